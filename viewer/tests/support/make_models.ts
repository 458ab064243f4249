import { mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { foramen, models, pointsOfPly } from './foramen';

/** A table of a point and a curve at the same landmarks of every shape. The point has no scatter. */
function marksAtLandmarks(corresponding: string): string {
  const rows = readdirSync(corresponding).flatMap((file) => {
    const points = pointsOfPly(join(corresponding, file));
    const row = (name: string, kind: string, index: number, landmark: number) =>
      [file.replace('.ply', ''), name, kind, index, ...points.subarray(3 * landmark, 3 * landmark + 3)].join();
    return [row('tip', 'point', 0, 17), ...[5, 100, 200].map((landmark, i) => row('rim', 'closed', i, landmark))];
  });
  return ['shape,landmark,kind,index,x,y,z', ...rows].join('\n');
}

/**
 * Makes, before the tests of the page, a small model of five inputs, of which one is left out, with marks, and its
 * baseline.
 */
export default async function makeModels(): Promise<() => void> {
  const work = mkdtempSync(join(tmpdir(), 'foramen_page_'));
  process.env.FORAMEN_MODELS = work;
  const { model, baseline } = models(),
    synth = join(work, 'synth'),
    inputs = join(synth, 'shapes');
  await foramen('synth', '-n', '4', '--seed', '7', '--vertices', '2500', '-o', synth);
  writeFileSync(join(inputs, 'broken.ply'), 'no mesh');
  const common = ['--samples', '5', '--quiet', '--subject-regex', '[0-9]+'];
  await foramen('build', inputs, '-o', model, '--landmarks', '400', ...common);
  // With this number of landmarks, closest points flip some triangles.
  await foramen('build', inputs, '-o', baseline, '--method', 'icp', '--landmarks', '1600', ...common);
  const marks = join(work, 'marks.csv');
  writeFileSync(marks, marksAtLandmarks(join(model, 'corresponding')));
  await foramen('evaluate', model, '--shapes', inputs, '--marks', marks, '-o', model, ...common);
  await foramen('report', model, '--baseline', baseline);
  return () => rmSync(work, { recursive: true, force: true });
}
