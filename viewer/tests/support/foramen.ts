import { execFile } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { promisify } from 'node:util';

/** Runs the program foramen. */
export async function foramen(...args: string[]): Promise<void> {
  const program = process.env.FORAMEN_PROGRAM;
  if (!program) throw new Error('FORAMEN_PROGRAM must name the program foramen');
  await promisify(execFile)(program, args);
}

/** The small model of synthetic vertebrae that make_models.ts made, and the ICP baseline of the same shapes. */
export function models(): { folder: string; model: string; baseline: string } {
  const folder = process.env.FORAMEN_MODELS!;
  return { folder, model: join(folder, 'model'), baseline: join(folder, 'closest') };
}

/** The points of a binary PLY file of foramen or of the page, whose vertices begin with the floats x y z. */
export function pointsOfPly(file: string | Buffer): Float32Array {
  const bytes = typeof file === 'string' ? readFileSync(file) : file;
  const end = bytes.indexOf('end_header\n') + 'end_header\n'.length;
  const count = Number(/element vertex (\d+)/.exec(bytes.subarray(0, end).toString())![1]);
  return Float32Array.from({ length: 3 * count }, (_, i) => bytes.readFloatLE(end + 4 * i));
}

export function largestDifference(a: Float32Array, b: Float32Array): number {
  if (a.length !== b.length) return Infinity;
  return a.reduce((largest, x, i) => Math.max(largest, Math.abs(x - b[i])), 0);
}
