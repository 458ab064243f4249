import { readFileSync } from 'node:fs';
import { defineConfig, type Plugin } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';

/** `REPORT=../model/report.html npm run dev` shows the page under development with the data of a report. */
function dataOfReport(report: string | undefined): Plugin {
  return {
    name: 'data-of-report',
    apply: 'serve',
    transformIndexHtml(page) {
      if (!report) throw new Error('name a report to take the data from: REPORT=../model/report.html npm run dev');
      const data = /<script id="report-data" type="application\/json">([^<]*)<\/script>/.exec(
        readFileSync(report, 'utf8'),
      );
      if (!data?.[1]) throw new Error(`${report}: is no interactive report`);
      return page.replace('@REPORT_DATA@', () => data[1]!);
    },
  };
}

export default defineConfig({
  plugins: [dataOfReport(process.env.REPORT), viteSingleFile({ removeViteModuleLoader: true })],
  build: { target: 'es2022', emptyOutDir: false, chunkSizeWarningLimit: 2000 },
});
