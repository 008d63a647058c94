import { defineConfig } from 'vitest/config';

// `npm run dev` shows the pages against a running `verstat serve --port 8080`.
export default defineConfig({
  build: {
    target: 'es2022',
    // The content security policy forbids data: scripts and inline styles, so nothing is inlined.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 800,
  },
  server: {
    // The gallery stands outside this folder.
    fs: { allow: ['../..'] },
    // The server answers only to its own name and origin.
    proxy: { '/api': { target: 'http://127.0.0.1:8080', changeOrigin: true, headers: { origin: 'http://127.0.0.1:8080' } } },
  },
  test: { include: ['tests/**/*.test.ts'] },
});
