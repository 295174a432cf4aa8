// The unit sphere at the origin, seen by a pinhole camera, for C++ and GLSL alike.
#ifndef LOBELIA_SPHERE_GLSL
#define LOBELIA_SPHERE_GLSL

#include "lobelia/language.glsl"
#include "lobelia/sphere_params.glsl"

// A ray through a point of the image. Its direction is not a unit vector. Its moment, eye x
// direction, tells how far from the sphere's centre it passes: |moment| / |direction|. Both are
// linear over the image, and the moment keeps its digits when the eye is a million radii away.
struct ImageRay {
    vec3 direction;
    vec3 moment;
};

// (x, y) in pixels right and down from the image's centre.
SHARED ImageRay image_ray(SphereParams params, float x, float y) {
    ImageRay ray;
    ray.direction = vec3(params.direction) + x * vec3(params.direction_per_x) +
                    y * vec3(params.direction_per_y);
    ray.moment =
        vec3(params.moment) + x * vec3(params.moment_per_x) + y * vec3(params.moment_per_y);
    return ray;
}

// The silhouette is where `inside` and `outside` are of equal length; on the sphere `inside` is
// longer, if the sphere is in front. |inside|^2 - |outside|^2 is |direction|^2 - |moment|^2 either
// way, but each way is accurate where the other one cancels. All are linear over the image.
struct Silhouette {
    vec3 inside;
    vec3 inside_per_x;
    vec3 inside_per_y;
    vec3 outside;
    vec3 outside_per_x;
    vec3 outside_per_y;
};

SHARED Silhouette silhouette(SphereParams params, ImageRay ray) {
    vec3 centre = vec3(params.centre);
    float tangent = params.centre.w;
    Silhouette s;
    if (tangent > 1.0f) {
        s.inside = ray.direction;
        s.inside_per_x = vec3(params.direction_per_x);
        s.inside_per_y = vec3(params.direction_per_y);
        s.outside = ray.moment;
        s.outside_per_x = vec3(params.moment_per_x);
        s.outside_per_y = vec3(params.moment_per_y);
    } else {
        s.inside = vec3(dot(centre, ray.direction), 0.0f, 0.0f);
        s.inside_per_x = vec3(dot(centre, vec3(params.direction_per_x)), 0.0f, 0.0f);
        s.inside_per_y = vec3(dot(centre, vec3(params.direction_per_y)), 0.0f, 0.0f);
        s.outside = tangent * ray.direction;
        s.outside_per_x = tangent * vec3(params.direction_per_x);
        s.outside_per_y = tangent * vec3(params.direction_per_y);
    }
    return s;
}

// Where the ray meets the sphere, or the point of the silhouette next to a ray that misses.
struct SurfacePoint {
    vec3 normal;
    vec3 mirror;    // direction in which a mirror would show the environment
    float cos_view; // from the normal to the eye, and to `mirror`
};

SHARED SurfacePoint surface_point(SphereParams params, ImageRay ray) {
    Silhouette s = silhouette(params, ray);
    float inside = length(s.inside);
    float outside = length(s.outside);
    float stretch = length(ray.direction);
    vec3 direction = ray.direction / stretch;
    vec3 nearest = cross(direction, ray.moment / stretch); // the ray's point next to the centre
    bool in_front = dot(vec3(params.centre), direction) > 0.0f;

    SurfacePoint point;
    float cosine = 0.0f;
    if (in_front && inside > outside)
        cosine = sqrt((inside - outside) / stretch * ((inside + outside) / stretch));
    vec3 normal = nearest - cosine * direction;
    float normal_length = length(normal);
    if (normal_length > 1e-3f)
        point.normal = normal / normal_length;
    else // the sphere is behind the ray and touches the eye: the only normal there is
        point.normal = -vec3(params.centre) / length(vec3(params.centre));
    point.cos_view = min(cosine, 1.0f);
    point.mirror = direction + 2.0f * point.cos_view * point.normal;
    return point;
}

// numerator / denominator held within a pixel, from -1/2 to 1/2, whatever they are.
SHARED float within_pixel(float numerator, float denominator) {
    if (abs(numerator) >= 0.5f * abs(denominator))
        return (numerator > 0.0f) == (denominator > 0.0f) ? 0.5f : -0.5f;
    return numerator / denominator;
}

// One root of a t^2 + b t + c is this over a, the other c over this.
SHARED float root_term(float b, float discriminant) {
    return -0.5f * (b + (b < 0.0f ? -1.0f : 1.0f) * sqrt(max(discriminant, 0.0f)));
}

// How much of t from -1/2 to 1/2 lies on the sphere: where a t^2 + b t + c > 0, and also
// front + t front_per_t > 0, since the quadric has a mirror image behind the camera.
SHARED float covered_length(float a, float b, float c, float front, float front_per_t) {
    float discriminant = b * b - 4.0f * a * c;
    if (a < 0.0f && discriminant <= 0.0f) return 0.0f;
    float root = root_term(b, discriminant);
    float t0 = within_pixel(root, a);
    float t1 = within_pixel(c, root);
    if (a < 0.0f) return front + 0.5f * (t0 + t1) * front_per_t > 0.0f ? abs(t0 - t1) : 0.0f;
    return front_per_t > 0.0f ? 0.5f - max(t0, t1) : min(t0, t1) + 0.5f;
}

const int COVERAGE_STRIPS = 8;

// Fraction of the pixel around the ray's point of the image that the sphere covers. The pixel is
// cut into strips across the silhouette, along each of which the silhouette's conic is solved;
// where the sphere is smaller than the pixel the strips lie on the sphere alone.
SHARED float sphere_coverage(SphereParams params, ImageRay ray) {
    Silhouette s = silhouette(params, ray);
    float inside = length(s.inside);
    float outside = length(s.outside);
    // An upper limit of how inside - outside changes from the pixel's centre to its corners.
    float reach = 0.5f * (length(s.inside_per_x) + length(s.inside_per_y) +
                          length(s.outside_per_x) + length(s.outside_per_y));
    float front = dot(vec3(params.centre), ray.direction);
    if (inside - outside > reach) return front > 0.0f ? 1.0f : 0.0f;
    if (outside - inside > reach) return 0.0f;

    float scale = 1.0f / max(max(inside, reach), 1e-30f); // keeps the squares of squares in range
    vec3 v = scale * s.inside;
    vec3 v_x = scale * s.inside_per_x;
    vec3 v_y = scale * s.inside_per_y;
    vec3 w = scale * s.outside;
    vec3 w_x = scale * s.outside_per_x;
    vec3 w_y = scale * s.outside_per_y;

    // t runs along a strip, u across them.
    float slope_x = dot(v, v_x) - dot(w, w_x);
    float slope_y = dot(v, v_y) - dot(w, w_y);
    bool along_x = abs(slope_x) > abs(slope_y);
    vec3 v_t = along_x ? v_x : v_y;
    vec3 w_t = along_x ? w_x : w_y;
    vec3 v_u = along_x ? v_y : v_x;
    vec3 w_u = along_x ? w_y : w_x;
    vec3 front_t = vec3(along_x ? params.direction_per_x : params.direction_per_y);
    vec3 front_u = vec3(along_x ? params.direction_per_y : params.direction_per_x);
    float front_per_t = dot(vec3(params.centre), front_t);
    float front_per_u = dot(vec3(params.centre), front_u);

    // The quadric a t^2 + (b + b_u u) t + (c + c_u u + c_uu u^2).
    float a = dot(v_t, v_t) - dot(w_t, w_t);
    float least = 1e-6f * (dot(v_t, v_t) + dot(w_t, w_t)) + 1e-30f;
    if (abs(a) < least) a = -least;
    float b = 2.0f * (along_x ? slope_x : slope_y);
    float b_u = 2.0f * (dot(v_u, v_t) - dot(w_u, w_t));
    float c = scale * (inside - outside) * scale * (inside + outside);
    float c_u = 2.0f * (along_x ? slope_y : slope_x);
    float c_uu = dot(v_u, v_u) - dot(w_u, w_u);

    // Strips that meet an ellipse lie between the roots of its discriminant over u.
    float first = -0.5f;
    float last = 0.5f;
    float extent = b_u * b_u - 4.0f * a * c_uu;
    if (a < 0.0f && extent < 0.0f) {
        float extent_u = 2.0f * b * b_u - 4.0f * a * c_u;
        float extent_1 = b * b - 4.0f * a * c;
        float discriminant = extent_u * extent_u - 4.0f * extent * extent_1;
        if (discriminant <= 0.0f) return 0.0f;
        float root = root_term(extent_u, discriminant);
        float u0 = within_pixel(root, extent);
        float u1 = within_pixel(extent_1, root);
        first = min(u0, u1);
        last = max(u0, u1);
    }
    float covered = 0.0f;
    for (int i = 0; i < COVERAGE_STRIPS; ++i) {
        float u = first + (last - first) * (float(i) + 0.5f) / float(COVERAGE_STRIPS);
        covered += covered_length(a, b + u * b_u, c + u * (c_u + u * c_uu),
                                  front + u * front_per_u, front_per_t);
    }
    return min(covered * (last - first) / float(COVERAGE_STRIPS), 1.0f);
}

#endif
