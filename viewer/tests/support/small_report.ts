import type { EncodedArray, ReportData } from '../../src/model/report_data';

export function encoded(values: Float32Array | Int8Array | Uint16Array | Uint32Array, shape: number[]): EncodedArray {
  const type =
    values instanceof Float32Array
      ? 'f32'
      : values instanceof Int8Array
        ? 'i8'
        : values instanceof Uint16Array
          ? 'u16'
          : 'u32';
  return { type, shape, base64: Buffer.from(values.buffer, values.byteOffset, values.byteLength).toString('base64') };
}

const around = 8,
  tube = 5;
const emptyTable = { title: '', note: '', header: [], rows: [] };

/**
 * A report of a torus of revolution with two modes (longer in x, thicker in z) and three shapes, in foramen's format.
 */
export function smallReport(): ReportData {
  const mean: number[] = [],
    longer: number[] = [],
    thicker: number[] = [],
    turns: number[] = [];
  for (let i = 0; i < around; ++i)
    for (let j = 0; j < tube; ++j) {
      const u = (2 * Math.PI * i) / around,
        v = (2 * Math.PI * j) / tube,
        r = 20 + 8 * Math.cos(v);
      mean.push(r * Math.cos(u), r * Math.sin(u), 8 * Math.sin(v));
      longer.push(0.1 * r * Math.cos(u), 0, 0);
      thicker.push(0, 0, 0.8 * Math.sin(v));
      turns.push(i / around, j / tube);
    }
  const triangles: number[] = [],
    jumps: number[] = [];
  const id = (i: number, j: number) => (i % around) * tube + (j % tube);
  const whole = (from: [number, number], to: [number, number]) => [
    Math.floor(to[0] / around) - Math.floor(from[0] / around),
    Math.floor(to[1] / tube) - Math.floor(from[1] / tube),
  ];
  for (let i = 0; i < around; ++i)
    for (let j = 0; j < tube; ++j)
      for (const corners of [
        [
          [i, j],
          [i + 1, j],
          [i + 1, j + 1],
        ],
        [
          [i, j],
          [i + 1, j + 1],
          [i, j + 1],
        ],
      ] as [number, number][][])
        for (let k = 0; k < 3; ++k) {
          triangles.push(id(...corners[k]));
          jumps.push(...whole(corners[k], corners[(k + 1) % 3]));
        }
  const points = around * tube;
  const shape = (name: string, scores: number[]) => ({
    name,
    subject: null,
    is_reference: false,
    scores,
    error: encoded(
      Uint16Array.from({ length: points }, (_, i) => 10 * i),
      [points],
    ),
    plain_flips: encoded(new Uint32Array(name === 'c' ? [3, 7] : []), [name === 'c' ? 2 : 0]),
    confirmed_flips: encoded(new Uint32Array(name === 'c' ? [7] : []), [name === 'c' ? 1 : 0]),
    mean_mm: 0.1,
    p95_mm: 0.2,
    hausdorff_mm: 0.39,
  });
  return {
    format: 'foramen-report',
    format_version: 1,
    foramen: '0',
    title: 't',
    subtitle: 's',
    plain_words: [],
    findings: [],
    model: {
      space: 'LPS',
      modes_of_model: 2,
      variance_shares: [0.8, 0.2],
      mean: encoded(new Float32Array(mean), [points, 3]),
      modes: encoded(new Float32Array([...longer, ...thicker]), [2, points, 3]),
      triangles: encoded(new Uint32Array(triangles), [triangles.length / 3, 3]),
    },
    torus: {
      lattice: [
        [1.5, 0.3],
        [0, 1 / 1.5],
      ],
      turns: encoded(new Float32Array(turns), [points, 2]),
      jumps: encoded(new Int8Array(jumps), [jumps.length / 2, 2]),
    },
    loops: [],
    marks: [],
    views: [],
    error_unit_mm: 0.001,
    shapes: [shape('a', [1, -1]), shape('b', [0, 0.5]), shape('c', [-1, 0.5])],
    charts: [],
    figures: [],
    differences: [],
    remarks: [],
    shapes_table: emptyTable,
    left_out: emptyTable,
    repaired: emptyTable,
    refit_failures: emptyTable,
    made_by: '',
    options: emptyTable,
    inputs: emptyTable,
    papers: emptyTable,
  };
}
