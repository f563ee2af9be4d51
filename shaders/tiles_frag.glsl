// Averages a planar map over an output pixel: exactly, from the lines in the tiles that the pixel's box overlaps. The
// formulas are those of LineTiles (libdepixel/raster/line_tiles.hpp) and of the CPU rasteriser.
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
uniform float levels;       // a colour's full strength
uniform bool linear_light;

out vec4 colour;

vec4 signed_halves(uvec2 words) {
  ivec4 halves = ivec4(words.x << 16, words.x, words.y << 16, words.y);
  return vec4(halves >> 16);
}

vec2 unsigned_halves(uint word) {
  return vec2(word & 0xffffu, word >> 16);
}

// The integral of clamp(x, 0, 1) up to x.
vec2 integral_of_clamp(vec2 x) {
  vec2 c = clamp(x, 0.0, 1.0);
  return c * (x - 0.5 * c);
}

// The part of a box that lies right of a line, as an area: positive if the line goes down.
float area_right_of(vec2 from, vec2 to, vec2 low, vec2 high) {
  vec2 y = clamp(vec2(from.y, to.y), low.y, high.y);
  float height = to.y - from.y;
  float slope = (to.x - from.x) / (abs(height) < 0.5 ? 1.0 : height);
  // How much of the box's width is right of the line, where it enters and leaves the box's rows.
  vec2 right = (high.x - from.x - (y - from.y) * slope) / (high.x - low.x);
  vec2 integral = integral_of_clamp(right);
  float way = right.y - right.x;
  float mean = abs(way) < 0.001 ? clamp(0.5 * (right.x + right.y), 0.0, 1.0) : (integral.y - integral.x) / way;
  return mean * (high.x - low.x) * (y.y - y.x);
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
  vec4 sum = signed_halves(tile.xy) * ((high.x - low.x) * (high.y - low.y));
  uint end = tile.z + tile.w;
  for (uint i = tile.z; i < end; ++i) {
    uvec4 line = texelFetch(lines, ivec2(int(i) & lines_layout.x, int(i) >> lines_layout.y), 0);
    vec2 from = unsigned_halves(line.x), to = unsigned_halves(line.y);
    sum += signed_halves(line.zw) *
           (area_right_of(from, to, low, high) + area_below_start(from, to, low, high));
  }
  return sum;
}

vec3 srgb_from_light(vec3 light) {
  vec3 power = 1.055 * pow(max(light, 0.0), vec3(1.0 / 2.4)) - 0.055;
  return mix(power, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - viewport.xy;
  pixel.y = viewport.z - 1 - pixel.y;
  vec2 low = origin + vec2(pixel) * box_size, high = origin + vec2(pixel + 1) * box_size;
  // A tile of which a box overlaps less than 1/512 of its own size is left out: it is rounding's.
  vec2 margin = box_size / 512.0;
  ivec2 first = max(ivec2(floor(low + margin)), -origin_tile);
  ivec2 last = min(ivec2(ceil(high - margin)), frame_size - origin_tile) - 1;
  vec4 sum = vec4(0.0);
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      vec2 corner = vec2(x, y);
      sum += sum_of_tile(origin_tile + ivec2(x, y), kTileUnits * clamp(low - corner, 0.0, 1.0),
                         kTileUnits * clamp(high - corner, 0.0, 1.0));
    }
  }
  sum /= levels * kTileUnits * kTileUnits * box_size.x * box_size.y;
  vec3 straight = sum.rgb / max(sum.a, 1e-6);
  colour = vec4(linear_light ? srgb_from_light(straight) : straight, sum.a);
  if (sum.a < 0.5 / 255.0) colour = vec4(0.0);
}
