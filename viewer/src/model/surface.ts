// Geometry of triangle surfaces. Points are given as x y z ..., triangles by their corners a b c ....

/** Area vectors (normal times twice the area) of the triangles. */
export function areaVectors(points: Float32Array, triangles: Uint32Array): Float32Array {
  const vectors = new Float32Array(triangles.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t],
      b = 3 * triangles[t + 1],
      c = 3 * triangles[t + 2];
    const ux = points[b] - points[a],
      uy = points[b + 1] - points[a + 1],
      uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a],
      vy = points[c + 1] - points[a + 1],
      vz = points[c + 2] - points[a + 2];
    vectors[t] = uy * vz - uz * vy;
    vectors[t + 1] = uz * vx - ux * vz;
    vectors[t + 2] = ux * vy - uy * vx;
  }
  return vectors;
}

/** Unit normals at the points: means of the normals of the triangles, weighted by area. */
export function pointNormals(pointCount: number, triangles: Uint32Array, vectors: Float32Array): Float32Array {
  const normals = new Float32Array(3 * pointCount);
  for (let t = 0; t < triangles.length; t += 3)
    for (let k = 0; k < 3; ++k) {
      const p = 3 * triangles[t + k];
      normals[p] += vectors[t];
      normals[p + 1] += vectors[t + 1];
      normals[p + 2] += vectors[t + 2];
    }
  for (let p = 0; p < normals.length; p += 3) {
    const length = Math.hypot(normals[p], normals[p + 1], normals[p + 2]) || 1;
    normals[p] /= length;
    normals[p + 1] /= length;
    normals[p + 2] /= length;
  }
  return normals;
}

/** The triangles whose normal opposes that of the same triangle of another shape. */
export function opposing(vectors: Float32Array, others: Float32Array): number[] {
  const found: number[] = [];
  for (let t = 0; t < vectors.length; t += 3)
    if (vectors[t] * others[t] + vectors[t + 1] * others[t + 1] + vectors[t + 2] * others[t + 2] < 0) found.push(t / 3);
  return found;
}

export interface SurfaceHit {
  triangle: number;
  /** The distance along the ray, in lengths of its direction vector. */
  at: number;
  /** The corner of the triangle that is nearest in barycentric coordinates. */
  landmark: number;
}

/** The first place where a ray meets the surface, on either side of it (Moeller and Trumbore 1997). */
export function firstHit(
  points: Float32Array,
  triangles: Uint32Array,
  origin: number[],
  direction: number[],
): SurfaceHit | null {
  const [ox, oy, oz] = origin,
    [dx, dy, dz] = direction;
  let hit: SurfaceHit | null = null;
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t],
      b = 3 * triangles[t + 1],
      c = 3 * triangles[t + 2];
    const ax = points[a],
      ay = points[a + 1],
      az = points[a + 2];
    const ux = points[b] - ax,
      uy = points[b + 1] - ay,
      uz = points[b + 2] - az;
    const vx = points[c] - ax,
      vy = points[c + 1] - ay,
      vz = points[c + 2] - az;
    const px = dy * vz - dz * vy,
      py = dz * vx - dx * vz,
      pz = dx * vy - dy * vx;
    const determinant = ux * px + uy * py + uz * pz;
    if (determinant === 0) continue;
    const sx = ox - ax,
      sy = oy - ay,
      sz = oz - az;
    const u = (sx * px + sy * py + sz * pz) / determinant;
    if (u < 0 || u > 1) continue;
    const qx = sy * uz - sz * uy,
      qy = sz * ux - sx * uz,
      qz = sx * uy - sy * ux;
    const v = (dx * qx + dy * qy + dz * qz) / determinant;
    if (v < 0 || u + v > 1) continue;
    const at = (vx * qx + vy * qy + vz * qz) / determinant;
    if (at <= 0 || (hit && at >= hit.at)) continue;
    const w = 1 - u - v;
    hit = { triangle: t / 3, at, landmark: triangles[t + (w >= u && w >= v ? 0 : u >= v ? 1 : 2)] };
  }
  return hit;
}
