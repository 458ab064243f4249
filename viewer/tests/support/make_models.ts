import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { foramen, models } from './foramen';

/** Makes, before the tests of the page, a small model of five inputs, of which one is left out, and its baseline. */
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
  await foramen('report', model, '--baseline', baseline);
  return () => rmSync(work, { recursive: true, force: true });
}
