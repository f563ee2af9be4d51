// Averages a planar map over an output pixel: exactly, from the lines in the tiles that the pixel's box overlaps. The
// formulas are those of LineTiles (libdepixel/raster/line_tiles.hpp) and of the CPU rasteriser.
// LINEAR_LIGHT is defined where colours are blended in linear light, and SHADED where they run inside regions: tiles tell
// regions then, by the colour that each has on the map.
// Source: Nehab and Hoppe, "Random-access rendering of general vector graphics" (2008); FreeType's smooth rasteriser.

const float kTileUnits = 32768.0;

uniform highp usampler2D tiles;  // of each source pixel: colour at its top left (2 words), first line, count of lines
uniform highp usampler2D lines;  // x0 y0, x1 y1, change of colour (2 words)
uniform ivec2 lines_layout;      // of a line's number: mask of its column, shift to its row

uniform ivec2 frame_size;   // source pixels
uniform ivec3 viewport;     // x, y, height, in the framebuffer's pixels
uniform ivec2 origin_tile;  // the source pixel at the viewport's top left
uniform vec2 origin;        // the viewport's top left in that pixel
uniform vec2 box_size;      // of an output pixel, in source pixels
uniform float to_full_strength;  // of a sum, over the area of the box and the levels of a colour

out vec4 colour;

vec4 signed_halves(uvec2 words) {
  ivec4 halves = ivec4(words.x << 16, words.x, words.y << 16, words.y);
  return vec4(halves >> 16);
}

#ifdef LINEAR_LIGHT
// To sRGB and back. Source: IEC 61966-2-1.
vec3 encode(vec3 light) {
  vec3 power = 1.055 * pow(max(light, 0.0), vec3(1.0 / 2.4)) - 0.055;
  return mix(power, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}
vec3 decode(vec3 srgb) {
  return mix(pow((srgb + 0.055) / 1.055, vec3(2.4)), srgb / 12.92, lessThanEqual(srgb, vec3(0.04045)));
}
#else
vec3 encode(vec3 srgb) {
  return srgb;
}
vec3 decode(vec3 srgb) {
  return srgb;
}
#endif

#ifdef SHADED
uniform highp usampler2D shading;  // of each block: its north-western pixel's shade and region, its pairs

// The block round the fragment's centre: its pixels from the north-west on, row by row.
uvec4 shades, regions;
uint pairs;
vec4 weights;

vec4 levels_of(uint colour) {
  return vec4(ivec4(uvec4(colour, colour >> 8, colour >> 16, colour >> 24) & 0xffu));
}

// Of the fragment's centre, in source pixels from the origin tile.
void find_block(vec2 centre) {
  vec2 place = centre + 0.5;
  ivec2 corner = clamp(origin_tile + ivec2(floor(place)), ivec2(0), frame_size);
  uvec4 north_west = texelFetch(shading, corner, 0), north_east = texelFetch(shading, corner + ivec2(1, 0), 0);
  uvec4 south_west = texelFetch(shading, corner + ivec2(0, 1), 0), south_east = texelFetch(shading, corner + 1, 0);
  shades = uvec4(north_west.x, north_east.x, south_west.x, south_east.x);
  regions = uvec4(north_west.y, north_east.y, south_west.y, south_east.y);
  pairs = north_west.z;
  vec2 after = clamp(fract(place), 1.0 / 4096.0, 4095.0 / 4096.0), before = 1.0 - after;
  weights = vec4(before.x * before.y, after.x * before.y, before.x * after.y, after.x * after.y);
}

// A set of pixels, with those of a pair if one of them is in another set.
uint with_pair(uint pixels, uint own, uint pair, uint both) {
  return (pairs & pair) != 0u && (own & both) != 0u ? pixels | both : pixels;
}

// What a region has at the fragment's centre; see Shading (libdepixel/stages/shading.hpp). Premultiplied, in the space
// that is blended in.
vec4 colour_of(uint region) {
  uint own = 0u;
  if (pairs != 0u) {
    uvec4 is_own = uvec4(equal(regions, uvec4(region)));
    own = is_own.x | is_own.y << 1 | is_own.z << 2 | is_own.w << 3;
  }
  vec4 levels = levels_of(region);
  if (own != 0u) {
    uint blending = with_pair(own, own, 1u, 3u);
    blending = with_pair(blending, own, 2u, 10u);
    blending = with_pair(blending, own, 4u, 12u);
    blending = with_pair(blending, own, 8u, 5u);
    blending = with_pair(blending, own, 16u, 9u);
    blending = with_pair(blending, own, 32u, 6u);
    vec4 shares = weights * vec4(ivec4(uvec4(blending, blending >> 1, blending >> 2, blending >> 3) & 1u));
    vec4 sum = shares.x * levels_of(shades.x) + shares.y * levels_of(shades.y) + shares.z * levels_of(shades.z) +
               shares.w * levels_of(shades.w);
    levels = floor(sum / (shares.x + shares.y + shares.z + shares.w) + 0.5);
  }
  vec4 strength = levels / 255.0;
  return vec4(decode(strength.rgb) * strength.a, strength.a);
}

vec4 colour_at_top_left(uvec4 tile) {
  return colour_of(tile.x);
}
vec4 change_of(uvec4 line) {
  return colour_of(line.z) - colour_of(line.w);
}
#else
vec4 colour_at_top_left(uvec4 tile) {
  return signed_halves(tile.xy);
}
vec4 change_of(uvec4 line) {
  return signed_halves(line.zw);
}
#endif

vec2 unsigned_halves(uint word) {
  return vec2(ivec2(word & 0xffffu, word >> 16));
}

// The part of a box that lies right of a line, as an area: positive if the line goes down.
float area_right_of(vec2 from, vec2 to, vec2 low, vec2 high) {
  vec2 y = clamp(vec2(from.y, to.y), low.y, high.y);
  float height = to.y - from.y;
  float slope = (to.x - from.x) / (abs(height) < 0.5 ? 1.0 : height);
  // How much of the box's rows is right of the line, where it enters and leaves them; and the integral of that, clamped
  // to the box, over the way between.
  vec2 right = high.x - from.x - (y - from.y) * slope;
  vec2 inside = clamp(right, 0.0, high.x - low.x);
  vec2 integral = inside * (right - 0.5 * inside);
  float way = right.y - right.x;
  float mean = abs(way) < 4.0 ? 0.5 * (inside.x + inside.y) : (integral.y - integral.x) / way;
  return mean * (y.y - y.x);
}

// What a line that meets the tile's left side changes below that place, as an area.
float area_below_start(vec2 from, vec2 to, vec2 low, vec2 high) {
  float begins = from.x == 0.0 ? -1.0 : to.x == 0.0 ? 1.0 : 0.0;
  float y = from.x == 0.0 ? from.y : to.y;
  return begins * (high.x - low.x) * max(high.y - max(y, low.y), 0.0);
}

// Sum of colours times areas over the part of a tile from low to high.
vec4 sum_of_tile(ivec2 position, vec2 low, vec2 high) {
  uvec4 tile = texelFetch(tiles, position, 0);
  vec4 sum = colour_at_top_left(tile) * ((high.x - low.x) * (high.y - low.y));
  int first = int(tile.z), end = first + int(tile.w);
  for (int i = first; i < end; ++i) {
    uvec4 line = texelFetch(lines, ivec2(i & lines_layout.x, i >> lines_layout.y), 0);
    vec2 from = unsigned_halves(line.x), to = unsigned_halves(line.y);
    sum += change_of(line) *
           (area_right_of(from, to, low, high) + area_below_start(from, to, low, high));
  }
  return sum;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - viewport.xy;
  pixel.y = viewport.z - 1 - pixel.y;
  vec2 low = origin + vec2(pixel) * box_size, high = origin + vec2(pixel + 1) * box_size;
#ifdef SHADED
  find_block(0.5 * (low + high));
#endif
  // A tile of which a box overlaps less than 1/512 of its own size is left out: it is rounding's. A box beside the frame
  // overlaps nothing of the tile that it is given.
  vec2 margin = box_size / 512.0;
  ivec2 east_south = frame_size - origin_tile - 1;
  ivec2 first = clamp(ivec2(floor(low + margin)), -origin_tile, east_south);
  ivec2 last = clamp(ivec2(ceil(high - margin)) - 1, first, east_south);
  vec4 sum = vec4(0.0);
  ivec2 tile = first;
  do {  // one loop, not two: what a loop costs dominates where there are few lines
    vec2 corner = vec2(tile);
    sum += sum_of_tile(origin_tile + tile, kTileUnits * clamp(low - corner, 0.0, 1.0),
                       kTileUnits * clamp(high - corner, 0.0, 1.0));
    ++tile.x;
    if (tile.x > last.x) tile = ivec2(first.x, tile.y + 1);
  } while (tile.y <= last.y);
  sum *= to_full_strength;
  colour = sum.a < 0.5 / 255.0 ? vec4(0.0) : vec4(encode(sum.rgb / sum.a), sum.a);
}
