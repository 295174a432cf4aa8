#include "support/oracle.h"

#include "support/parallel.h"
#include "support/patch_integral.h"
#include "support/texel_table.h"

namespace lobelia::oracle {
namespace {

struct Sum {
    Rgb radiance{};
    double weight = 0;
};

Direction in_frame(const FaceFrame& frame, Direction d) {
    return {dot(d, frame.right), dot(d, frame.down), dot(d, frame.outwards)};
}

// Adds the texels of one layer; the weight's directions are in the frame of the layer's chart.
template <class Chart>
void add_layer(const Source& source, int layer, const Weight& weight, int extra_points, Sum& sum) {
    const TexelTable& table = source.table();
    const PatchIntegral<Chart> integral(weight, extra_points);
    const auto width = std::size_t(source.width());

    std::array<std::vector<ProjectedColumn>, MAX_TABLE_POINTS + 1> columns;
    const auto projected = [&](std::size_t m) -> const std::vector<ProjectedColumn>& {
        if (columns[m].empty())
            for (const Column& column : table.columns[m])
                columns[m].push_back(integral.project(column));
        return columns[m];
    };
    const std::vector<ProjectedColumn>& middles = projected(1);
    const double largest = *std::max_element(table.radius.begin(), table.radius.end());
    double least_cosine = integral.least_cosine(largest);

    for (int y = 0; y < source.height(); ++y) {
        const Row row = table.rows[1][std::size_t(y)];
        if (!source.is_cube()) least_cosine = integral.least_cosine(table.radius[std::size_t(y)]);
        for (int x = 0; x < source.width(); ++x) {
            const ProjectedColumn& column = middles[std::size_t(x)];
            const double scale = Chart::scale(column.column, row);
            const double cosine = (column.axis * row.radius + weight.axis.y * row.y) * scale;
            if (cosine < least_cosine) continue;
            const double normal_cosine =
                weight.clamped ? (column.normal * row.radius + weight.normal.y * row.y) * scale : 1;
            const double radius = table.radius[std::size_t(y) * (source.is_cube() ? width : 1) +
                                               (source.is_cube() ? std::size_t(x) : 0)];
            if (normal_cosine <= -radius) continue;

            const Box box = table.box(x, y);
            const auto m = std::size_t(integral.plain_order(
                cosine, normal_cosine, radius, 0.5 * std::max(box.width(), box.height())));
            const double part =
                m == 0 ? integral.over(box)
                       : integral.plain(box, {projected(m).data() + std::size_t(x) * m, m},
                                        {table.rows[m].data() + std::size_t(y) * m, m});
            const Rgb& texel = source.texel(layer, x, y);
            for (std::size_t c = 0; c < 3; ++c) sum.radiance[c] += texel[c] * part;
            sum.weight += part;
        }
    }
}

Sum integrate(const Source& source, const Weight& weight, const Options& options) {
    Sum sum;
    if (!source.is_cube()) {
        add_layer<Panorama>(source, 0, weight, options.extra_points, sum);
        return sum;
    }
    for (int face = 0; face < 6; ++face) {
        Weight turned = weight;
        turned.axis = in_frame(cube_face(face), weight.axis);
        turned.normal = in_frame(cube_face(face), weight.normal);
        add_layer<CubeFace>(source, face, turned, options.extra_points, sum);
    }
    return sum;
}

Rgb times(double factor, Rgb value) {
    for (double& channel : value) channel *= factor;
    return value;
}

} // namespace

Rgb lobe_average(const Source& source, Direction axis, double exponent, Options options) {
    const Sum sum = integrate(source, {axis, Power(exponent)}, options);
    return times(options.normalise == Normalise::by_weight ? 1 / sum.weight
                                                           : (exponent + 1) / (2 * PI),
                 sum.radiance);
}

std::vector<Rgb> lobe_averages(const Source& source, const std::vector<Direction>& axes,
                               double exponent, Options options) {
    std::vector<Rgb> averages(axes.size());
    parallel_for(axes.size(), [&](std::size_t i) {
        averages[i] = lobe_average(source, axes[i], exponent, options);
    });
    return averages;
}

Rgb specular_average(const Source& source, Direction normal, Direction axis, double exponent,
                     Options options) {
    const Sum sum = integrate(source, {axis, Power(exponent), true, normal}, options);
    return times((exponent + 2) / (2 * PI), sum.radiance);
}

Rgb shade(const Source& source, Direction normal, Direction view, const Material& material,
          Options options) {
    const Rgb diffuse = lobe_average(source, normal, 1, options);
    const Rgb specular =
        specular_average(source, normal, mirror(normal, view), material.exponent, options);
    Rgb radiance{};
    for (std::size_t c = 0; c < 3; ++c)
        radiance[c] = material.diffuse[c] * diffuse[c] + material.specular[c] * specular[c];
    return radiance;
}

} // namespace lobelia::oracle
