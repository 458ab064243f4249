/** A shape as a binary PLY file, in millimetres, with foramen's SPACE tag for the axes. */
export function plyOf(points: Float32Array, triangles: Uint32Array, space: string): Blob {
  const header =
    `ply\nformat binary_little_endian 1.0\ncomment SPACE=${space}\nelement vertex ${points.length / 3}\n` +
    'property float x\nproperty float y\nproperty float z\n' +
    `element face ${triangles.length / 3}\nproperty list uchar int vertex_indices\nend_header\n`;
  const faces = new DataView(new ArrayBuffer((triangles.length / 3) * 13));
  for (let t = 0; t < triangles.length / 3; ++t) {
    faces.setUint8(13 * t, 3);
    for (let k = 0; k < 3; ++k) faces.setInt32(13 * t + 1 + 4 * k, triangles[3 * t + k], true);
  }
  return new Blob([header, points.slice().buffer, faces.buffer], { type: 'application/octet-stream' });
}
