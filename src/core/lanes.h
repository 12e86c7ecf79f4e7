// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <immintrin.h>
#endif

// Several pixels at a time, one a lane, as many as the instruction set that this is compiled for works on at once: a pixel's
// result is the same in every lane and at every width. Everything is in an anonymous namespace and free of library headers, so
// that a source compiled for a wider instruction set never lends its code to the others.
namespace
{

#if defined(__AVX512F__)
constexpr int lane_count = 16;
#elif defined(__AVX2__)
constexpr int lane_count = 8;
#else
constexpr int lane_count = 4;
#endif

typedef float Lanes __attribute__ ((vector_size (lane_count * sizeof (float))));
typedef std::int32_t LaneMask __attribute__ ((vector_size (lane_count * sizeof (std::int32_t))));

inline Lanes
load (const float* values)
{
  Lanes lanes;
  std::memcpy (&lanes, values, sizeof (lanes));
  return (lanes);
}

inline void
store (const Lanes& lanes, float* values)
{
  std::memcpy (values, &lanes, sizeof (lanes));
}

/** \brief The first lanes only. */
inline void
store (const Lanes& lanes, float* values, int count)
{
  if (count >= lane_count)
    store (lanes, values);
  else
    std::memcpy (values, &lanes, count * sizeof (float));
}

/** \brief The first values; 0 in the other lanes. */
inline Lanes
load (const float* values, int count)
{
  if (count >= lane_count)
    return (load (values));
  Lanes lanes{};
  std::memcpy (&lanes, values, count * sizeof (float));
  return (lanes);
}

/** \brief Which of the first bytes are not 0. */
inline LaneMask
loadFlags (const std::uint8_t* values, int count)
{
  typedef std::uint8_t Bytes __attribute__ ((vector_size (lane_count)));
  Bytes bytes{};
  std::memcpy (&bytes, values, count >= lane_count ? lane_count : count);
  return (__builtin_convertvector (bytes, LaneMask) != 0);
}

/** \brief Numbers from 0 to 255 in the first lanes. */
inline void
storeBytes (const LaneMask& lanes, std::uint8_t* values, int count)
{
  typedef std::uint8_t Bytes __attribute__ ((vector_size (lane_count)));
  const Bytes bytes = __builtin_convertvector (lanes, Bytes);
  std::memcpy (values, &bytes, count >= lane_count ? lane_count : count);
}

inline Lanes
broadcast (float value)
{
  return (value - Lanes{});
}

inline bool
any (const LaneMask& mask)
{
#if defined(__AVX512F__)
  return (_mm512_test_epi32_mask (reinterpret_cast<__m512i> (mask), reinterpret_cast<__m512i> (mask)) != 0);
#elif defined(__AVX2__)
  return (_mm256_movemask_ps (reinterpret_cast<__m256> (mask)) != 0);
#elif defined(__SSE2__)
  return (_mm_movemask_ps (reinterpret_cast<__m128> (mask)) != 0);
#else
  std::int32_t result = 0;
  for (int lane = 0; lane < lane_count; ++lane)
    result |= mask[lane];
  return (result != 0);
#endif
}

inline Lanes
select (const LaneMask& mask, const Lanes& yes, const Lanes& no)
{
  return (mask ? yes : no);
}

/** \brief The value where the mask is set, else 0. */
inline Lanes
keep (const LaneMask& mask, const Lanes& lanes)
{
  return (reinterpret_cast<Lanes> (mask & reinterpret_cast<LaneMask> (lanes)));
}

inline Lanes
absolute (const Lanes& lanes)
{
  return (reinterpret_cast<Lanes> (reinterpret_cast<LaneMask> (lanes) & 0x7fffffff));
}

inline Lanes
maximum (const Lanes& a, const Lanes& b)
{
  return (select (a > b, a, b));
}

inline Lanes
minimum (const Lanes& a, const Lanes& b)
{
#if defined(__AVX512F__)
  return (_mm512_maskz_min_ps (0xffff, a, b)); // without a mask GCC 12 warns falsely
#elif defined(__AVX2__)
  return (_mm256_min_ps (a, b));
#elif defined(__SSE2__)
  return (_mm_min_ps (a, b));
#else
  return (select (a < b, a, b));
#endif
}

/** \brief Add a value where the mask is set. */
inline void
addWhere (const LaneMask& mask, const Lanes& value, Lanes& sum)
{
#ifdef __AVX512F__
  sum = select (mask, sum + value, sum); // one masked instruction
#else
  sum += keep (mask, value);
#endif
}

inline Lanes
squareRoot (const Lanes& lanes)
{
#if defined(__AVX512F__)
  return (_mm512_maskz_sqrt_ps (0xffff, lanes)); // without a mask GCC 12 warns falsely
#elif defined(__AVX2__)
  return (_mm256_sqrt_ps (lanes));
#elif defined(__SSE2__)
  return (_mm_sqrt_ps (lanes));
#else
  Lanes result{};
  for (int lane = 0; lane < lane_count; ++lane)
    result[lane] = __builtin_sqrtf (lanes[lane]);
  return (result);
#endif
}

/** \brief exp (x) for x <= 0, to 2 units in the last place; 0 under -87 (Cephes' expf polynomial). */
inline Lanes
exponential (const Lanes& x)
{
  const LaneMask too_small = x < -87.0f;
  const Lanes clamped = select (too_small, Lanes{}, x);
  constexpr float rounding = 12582912.0f; // 1.5 * 2^23: adding it leaves the nearest integer in the low bits
  const Lanes shifted = clamped * 1.44269504088896341f + rounding;
  const Lanes n = shifted - rounding;
  const Lanes r = (clamped - n * 0.693359375f) - n * -2.12194440e-4f;
  Lanes polynomial = broadcast (1.9875691500e-4f);
  polynomial = polynomial * r + 1.3981999507e-3f;
  polynomial = polynomial * r + 8.3334519073e-3f;
  polynomial = polynomial * r + 4.1665795894e-2f;
  polynomial = polynomial * r + 1.6666665459e-1f;
  polynomial = polynomial * r + 5.0000001201e-1f;
  const Lanes fraction = polynomial * r * r + r + 1.0f;
  const LaneMask bits = reinterpret_cast<LaneMask> (shifted) - 0x4B400000; // the bits of 1.5 * 2^23
  const Lanes power = reinterpret_cast<Lanes> ((bits + 127) << 23);
  return (keep (~too_small, fraction * power));
}

/** \brief The even or the odd ones of 2 * lane_count values. */
inline void
splitLanes (const Lanes& first, const Lanes& second, Lanes& even, Lanes& odd)
{
#if defined(__AVX512F__)
  even = __builtin_shufflevector (first, second, 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
  odd = __builtin_shufflevector (first, second, 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31);
#elif defined(__AVX2__)
  even = __builtin_shufflevector (first, second, 0, 2, 4, 6, 8, 10, 12, 14);
  odd = __builtin_shufflevector (first, second, 1, 3, 5, 7, 9, 11, 13, 15);
#else
  even = __builtin_shufflevector (first, second, 0, 2, 4, 6);
  odd = __builtin_shufflevector (first, second, 1, 3, 5, 7);
#endif
}

/** \brief A vector a lane. */
struct LaneVector
{
  Lanes x, y, z;
};

inline LaneVector
operator+ (const LaneVector& a, const LaneVector& b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline LaneVector
operator- (const LaneVector& a, const LaneVector& b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline LaneVector
operator* (const LaneVector& a, const Lanes& factor)
{
  return {a.x * factor, a.y * factor, a.z * factor};
}

inline Lanes
dot (const LaneVector& a, const LaneVector& b)
{
  return (a.x * b.x + a.y * b.y + a.z * b.z);
}

inline LaneVector
cross (const LaneVector& a, const LaneVector& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline LaneVector
select (const LaneMask& mask, const LaneVector& yes, const LaneVector& no)
{
  return {select (mask, yes.x, no.x), select (mask, yes.y, no.y), select (mask, yes.z, no.z)};
}

/** \brief Unit length; 0 where the vector is 0. */
inline LaneVector
normalized (const LaneVector& v)
{
  const Lanes square = dot (v, v);
  const LaneMask defined = square > 1e-30f;
  return (v * keep (defined, 1.0f / squareRoot (select (defined, square, broadcast (1.0f)))));
}

/** \brief A symmetric 3x3 matrix a lane. */
struct LaneSymmetricMatrix
{
  Lanes xx, xy, xz, yy, yz, zz;
};

/** \brief Eigenvectors (unit, orthogonal, in no order) and eigenvalues of a symmetric matrix in closed form: the eigenvalue that
  * lies apart from the other two is a root of a cubic, the rest is a problem in the plane perpendicular to its vector.
  * The coordinate axes where the matrix is a multiple of the identity. */
inline void
eigenDecomposition (const LaneSymmetricMatrix& matrix, LaneVector (&vectors)[3], Lanes (&values)[3])
{
  const Lanes mean = (matrix.xx + matrix.yy + matrix.zz) * (1.0f / 3.0f);
  LaneSymmetricMatrix b{matrix.xx - mean, matrix.xy, matrix.xz, matrix.yy - mean, matrix.yz, matrix.zz - mean};
  const Lanes spread = squareRoot ((b.xx * b.xx + b.yy * b.yy + b.zz * b.zz +
                                    2.0f * (b.xy * b.xy + b.xz * b.xz + b.yz * b.yz)) * (1.0f / 6.0f));
  const LaneMask isotropic = spread <= 1e-18f;
  const Lanes scale = keep (~isotropic, 1.0f / select (isotropic, broadcast (1.0f), spread));
  b = {b.xx * scale, b.xy * scale, b.xz * scale, b.yy * scale, b.yz * scale, b.zz * scale};
  const Lanes half_determinant = 0.5f * (b.xx * (b.yy * b.zz - b.yz * b.yz) - b.xy * (b.xy * b.zz - b.yz * b.xz) +
                                         b.xz * (b.xy * b.yz - b.yy * b.xz));
  const Lanes size = select (absolute (half_determinant) > 1.0f, broadcast (1.0f), absolute (half_determinant));

  // Largest root of t^3 - 3t - 2|r| = 0, by a series around |r| = 1 and two steps of Newton.
  const Lanes s = 1.0f - squareRoot ((1.0f + size) * 0.5f);
  Lanes root = 2.0f - s * (8.0f / 9.0f) - s * s * (20.0f / 243.0f);
  for (int step = 0; step < 2; ++step)
    root = root - (root * root * root - 3.0f * root - 2.0f * size) / (3.0f * root * root - 3.0f);
  const Lanes apart = select (half_determinant < 0.0f, -root, root);

  const LaneVector row0{b.xx - apart, b.xy, b.xz}, row1{b.xy, b.yy - apart, b.yz}, row2{b.xz, b.yz, b.zz - apart};
  const LaneVector cross01 = cross (row0, row1), cross02 = cross (row0, row2), cross12 = cross (row1, row2);
  const Lanes square01 = dot (cross01, cross01), square02 = dot (cross02, cross02), square12 = dot (cross12, cross12);
  LaneVector first = select (square02 > square01, cross02, cross01);
  first = select (square12 > maximum (square01, square02), cross12, first);
  first = normalized (first);
  const LaneMask undefined = dot (first, first) < 0.5f;
  first = select (undefined, LaneVector{broadcast (1.0f), Lanes{}, Lanes{}}, first);

  // An orthonormal basis of the plane perpendicular to it without branches (Duff et al. 2017).
  const Lanes sign = select (first.z < 0.0f, broadcast (-1.0f), broadcast (1.0f));
  const Lanes a = -1.0f / (sign + first.z);
  const Lanes c = first.x * first.y * a;
  const LaneVector u{1.0f + sign * first.x * first.x * a, sign * c, -sign * first.x};
  const LaneVector v{c, sign + first.y * first.y * a, -first.y};
  const auto times = [&b] (const LaneVector& w) {
    return (LaneVector{b.xx * w.x + b.xy * w.y + b.xz * w.z, b.xy * w.x + b.yy * w.y + b.yz * w.z,
                       b.xz * w.x + b.yz * w.y + b.zz * w.z});
  };
  const LaneVector bu = times (u), bv = times (v);
  const Lanes uu = dot (u, bu), uv = dot (u, bv), vv = dot (v, bv);
  const Lanes half_difference = 0.5f * (uu - vv);
  const Lanes radius = squareRoot (half_difference * half_difference + uv * uv);
  const LaneMask round = radius <= 1e-18f;
  const Lanes inverse_radius = keep (~round, 1.0f / select (round, broadcast (1.0f), radius));
  const Lanes cosine =
    select (round, broadcast (1.0f), squareRoot (0.5f + 0.5f * absolute (half_difference) * inverse_radius));
  const LaneMask negative = half_difference < 0.0f;
  const Lanes magnitude = 0.5f * uv * inverse_radius / cosine;
  const Lanes sine = select (negative, -magnitude, magnitude);
  const Lanes middle = 0.5f * (uu + vv), signed_radius = select (negative, -radius, radius);

  vectors[0] = first;
  vectors[1] = u * cosine + v * sine;
  vectors[2] = v * cosine - u * sine;
  values[0] = mean + spread * apart;
  values[1] = mean + spread * (middle + signed_radius);
  values[2] = mean + spread * (middle - signed_radius);
}

} // namespace
