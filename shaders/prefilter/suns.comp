// Finds the suns. Texels above 64 times the clamped mean count as bright; the brightest is a sun's
// seed, all bright texels within 0.015 radians belong to it, and so on until none is left or the list
// is full. What does not fit stays in the map. One workgroup, in a fixed order: the same bits on
// every run.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/cube.glsl"
#include "lobelia/suns.glsl"
#include "radiance.glsl"
layout(set = 0, binding = 2, std430) buffer State { PrefilterState state; };
#include "prefilter/state.glsl"

const uint TEAM = 64u; // also the texels of a tile
layout(local_size_x = 64) in;

layout(set = 0, binding = 0) uniform sampler2DArray source;
layout(set = 0, binding = 1, std430) readonly buffer Tiles { vec4 tiles[]; }; // mean, solid angle, most

layout(push_constant) uniform Params {
    uint size;
    float ladder_lowest;
};

const float BRIGHT = 64.0; // times the clamped mean
const uint FINE_SIZE = 64u;      // of a source whose mean is taken texel by texel
const uint MOST_TILES = 512u; // with bright texels
const float LARGEST = 3.4e38;
const float LEAST = 1e-36; // of a sun's luminance: below, sums of it are denormal and may be 0

shared float team_values[TEAM];
shared uint team_tiles[TEAM];
shared vec4 team_sums[TEAM];
shared uint bright_tiles[MOST_TILES];
shared float most_left[MOST_TILES]; // largest luminance that no sun has taken, in each bright tile
shared vec4 seed;                   // direction; w: luminance

uint lane;
uint tile_count;

float team_total(float mine) {
    barrier();
    team_values[lane] = mine;
    for (uint half_team = TEAM / 2u; half_team > 0u; half_team /= 2u) {
        barrier();
        if (lane < half_team) team_values[lane] += team_values[lane + half_team];
    }
    barrier();
    return team_values[0];
}

vec4 team_total(vec4 mine) {
    barrier();
    team_sums[lane] = mine;
    for (uint half_team = TEAM / 2u; half_team > 0u; half_team /= 2u) {
        barrier();
        if (lane < half_team) team_sums[lane] += team_sums[lane + half_team];
    }
    barrier();
    return team_sums[0];
}

// Texel number `i` of a tile: x and y, and the face in z.
uvec3 texel_of(uint tile, uint i) {
    uint across = size / 8u;
    uint rest = tile % (across * across);
    return uvec3(rest % across * 8u + i % 8u, rest / across * 8u + i / 8u, tile / (across * across));
}

vec3 texel_direction(uvec3 texel) {
    return normalize(cube_direction(texel.z, cube_texel_centre(texel.x, size),
                                    cube_texel_centre(texel.y, size)));
}

vec3 radiance_at(uvec3 texel) { return sane(texelFetch(source, ivec3(texel), 0).rgb); }

// A tile's light with nothing above the threshold: its mean clamped, or where a tile is so much of the
// sphere that one sun lifts its mean, each of its texels.
float clamped_light(uint tile, float threshold) {
    if (size > FINE_SIZE) return min(tiles[tile].x, threshold) * tiles[tile].y;
    vec2 sum = vec2(0.0); // light times weight, weight
    for (uint i = 0u; i < TEAM; ++i) {
        uvec3 texel = texel_of(tile, i);
        float u = cube_texel_centre(texel.x, size);
        float v = cube_texel_centre(texel.y, size);
        float shrink = inversesqrt(1.0 + u * u + v * v);
        float weight = shrink * shrink * shrink;
        sum += vec2(min(luminance(radiance_at(texel)), threshold), 1.0) * weight;
    }
    return sum.x / sum.y * tiles[tile].y;
}

// The mean with the light clamped at 64 times itself, found by going on from no clamp at all. Each
// step takes off the share of the sphere that is clamped, times 64.
float clamped_mean() {
    float mean = 0.0;
    float threshold = LARGEST;
    int iterations = size > FINE_SIZE ? 6 : 40;
    for (int i = 0; i < iterations; ++i) {
        float light = 0.0;
        float solid_angle = 0.0;
        for (uint tile = lane; tile < tile_count; tile += TEAM) {
            // A sixteenth, so that the largest numbers do not overflow.
            light += clamped_light(tile, threshold) * 0.0625;
            solid_angle += tiles[tile].y * 0.0625;
        }
        mean = team_total(light) / team_total(solid_angle);
        threshold = min(BRIGHT * mean, LARGEST);
    }
    return mean;
}

// Lists the tiles with texels above the threshold, in their order, and returns their number; raises
// the threshold until the list holds them.
uint list_bright_tiles(inout float threshold) {
    uint share = (tile_count + TEAM - 1u) / TEAM;
    uint first = min(lane * share, tile_count);
    uint end = min(first + share, tile_count);
    uint total = MOST_TILES + 1u;
    uint before = 0u;
    while (total > MOST_TILES) {
        uint mine = 0u;
        for (uint tile = first; tile < end; ++tile) mine += tiles[tile].z > threshold ? 1u : 0u;
        barrier();
        team_tiles[lane] = mine;
        barrier();
        total = 0u;
        before = 0u;
        for (uint i = 0u; i < TEAM; ++i) {
            if (i == lane) before = total;
            total += team_tiles[i];
        }
        if (total > MOST_TILES) threshold *= 2.0;
    }
    for (uint tile = first; tile < end; ++tile) {
        if (tiles[tile].z <= threshold) continue;
        bright_tiles[before] = tile;
        most_left[before] = tiles[tile].z;
        ++before;
    }
    barrier();
    return total;
}

// The bright tile with the largest luminance left: the first of equals. The luminance is then in
// team_values[0].
uint brightest(uint count) {
    float most = -1.0;
    uint best = 0u;
    for (uint i = lane; i < count; i += TEAM) {
        if (most_left[i] > most) {
            most = most_left[i];
            best = i;
        }
    }
    barrier();
    team_values[lane] = most;
    team_tiles[lane] = best;
    for (uint half_team = TEAM / 2u; half_team > 0u; half_team /= 2u) {
        barrier();
        if (lane >= half_team) continue;
        float other = team_values[lane + half_team];
        uint other_tile = team_tiles[lane + half_team];
        if (other > team_values[lane] ||
            (other == team_values[lane] && other_tile < team_tiles[lane])) {
            team_values[lane] = other;
            team_tiles[lane] = other_tile;
        }
    }
    barrier();
    return team_tiles[0];
}

// The brightest texel of a tile that no sun has taken yet becomes the next sun's seed.
void find_seed(uint tile, uint suns) {
    uvec3 texel = texel_of(tile, lane);
    bool left = !near_sun(texel_direction(texel), suns);
    barrier();
    team_values[lane] = left ? luminance(radiance_at(texel)) : -1.0;
    barrier();
    if (lane == 0u) {
        uint best = 0u;
        for (uint i = 1u; i < TEAM; ++i) {
            if (team_values[i] > team_values[best]) best = i;
        }
        seed = vec4(texel_direction(texel_of(tile, best)), 0.0);
        state.seeds[suns] = seed;
    }
    memoryBarrierBuffer();
    barrier();
}

// Sums the bright texels around the seed into sun number `sun` and notes what each tile has left.
void gather(uint sun, float threshold, uint count) {
    vec4 moment = vec4(0.0); // direction from the seed times luminous energy; w: luminous energy
    vec4 energy = vec4(0.0); // w: chord from the seed times luminous energy
    float near = 0.015 + 12.0 / float(size); // a tile's centre is that far from its corners, at most
    for (uint i = 0u; i < count; ++i) {
        uint tile = bright_tiles[i];
        if (half_square_distance(texel_direction(texel_of(tile, 27u)), seed.xyz) > 0.5 * near * near) {
            continue;
        }
        uvec3 texel = texel_of(tile, lane);
        vec3 direction = texel_direction(texel);
        vec3 radiance = radiance_at(texel);
        float light = luminance(radiance);
        bool left = light > threshold && !near_sun(direction, sun);
        float chord = half_square_distance(direction, seed.xyz);
        bool mine = left && chord < SUN_CHORD;
        if (mine) {
            float u = cube_texel_centre(texel.x, size);
            float v = cube_texel_centre(texel.y, size);
            float shrink = inversesqrt(1.0 + u * u + v * v);
            float solid_angle = 4.0 / (float(size) * float(size)) * shrink * shrink * shrink;
            vec3 excess = radiance * (1.0 - threshold / light) * solid_angle;
            float weight = luminance(excess);
            moment += weight * vec4(direction - seed.xyz, 1.0);
            energy += vec4(excess, weight * (chord + solid_angle / 12.0)); // and the texel's own box
        }
        barrier();
        team_values[lane] = left && !mine ? light : 0.0;
        barrier();
        if (lane == 0u) {
            float most = 0.0;
            for (uint k = 0u; k < TEAM; ++k) most = max(most, team_values[k]);
            most_left[i] = most;
        }
    }
    moment = team_total(moment);
    energy = team_total(energy);
    if (lane == 0u) {
        // Light that only just counts as bright may be too little for its moments.
        vec3 shift = moment.w > 0.0 ? moment.xyz / moment.w : vec3(0.0);
        // The mean chord about the centre is that about the seed, less the shift's.
        float chord = moment.w > 0.0 ? energy.w / moment.w : 0.0;
        float extent = max(chord - 0.5 * dot(shift, shift), 0.0);
        state.suns[sun] = Sun(vec4(normalize(seed.xyz + shift), extent), vec4(energy.rgb, 0.0));
    }
    barrier();
}

void main() {
    lane = gl_LocalInvocationIndex;
    tile_count = 6u * (size / 8u) * (size / 8u);

    float mean = clamped_mean();
    float threshold = clamp(BRIGHT * mean, LEAST, LARGEST);
    uint count = list_bright_tiles(threshold);
    uint suns = 0u;
    for (; suns < MOST_SUNS; ++suns) {
        uint best = brightest(count);
        if (team_values[0] <= threshold) break;
        find_seed(bright_tiles[best], suns);
        gather(suns, threshold, count);
    }
    if (lane < MOST_SUNS && lane >= suns) {
        state.suns[lane] = Sun(vec4(0.0), vec4(0.0));
        state.seeds[lane] = vec4(0.0); // no direction is near it
    }
    if (lane == 0u) {
        // The power of two that brings the mean between 1 and 2.
        int exponent = int((floatBitsToUint(mean) >> 23) & 255u) - 127;
        state.threshold = threshold;
        state.scale = mean > 1e-37 ? ldexp(1.0, clamp(-exponent, -126, 126)) : 1.0;
        state.sun_count = suns;
        state.ladder_lowest = ladder_lowest;
    }
}
