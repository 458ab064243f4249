import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    dir: 'tests/page',
    globalSetup: 'tests/support/make_models.ts',
    fileParallelism: false,
    testTimeout: 120_000,
    hookTimeout: 300_000,
    reporters: ['verbose'],
  },
});
