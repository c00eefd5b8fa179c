import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig, type ProxyOptions } from 'vite';

/** While one develops: a run with its page, `sieben run PATH --page`. It answers its own host and origin alone. */
const RUN = '127.0.0.1:7300';
const proxy: ProxyOptions = {
  target: `http://${RUN}`,
  changeOrigin: true,
  ws: true,
  configure: (to) => {
    to.on('proxyReq', (request) => request.setHeader('origin', `http://${RUN}`));
    to.on('proxyReqWs', (request) => request.setHeader('origin', `http://${RUN}`));
  },
};

export default defineConfig({
  plugins: [svelte()],
  html: { cspNonce: '__NONCE__' },
  build: {
    outDir: '../dist',
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0,
    reportCompressedSize: false,
  },
  server: { proxy: { '/api': proxy, '/ws': proxy, '/docs': proxy } },
});
