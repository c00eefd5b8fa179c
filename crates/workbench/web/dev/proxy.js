// Serves the built page before a real server: `UPSTREAM=127.0.0.1:7300 PORT=7302 node dev/proxy.js`. The server sees its own host and origin.
import { createServer, request as ask } from 'node:http';
import { existsSync, readFileSync } from 'node:fs';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import WebSocket, { WebSocketServer } from 'ws';

const upstream = process.env.UPSTREAM ?? '127.0.0.1:7300';
const [host, hostPort] = upstream.split(':');
const port = Number(process.env.PORT ?? 7302);
const dist = fileURLToPath(new URL('../../dist/', import.meta.url));
const TYPES = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml' };

const server = createServer((request, response) => {
  const path = new URL(request.url, 'http://x').pathname;
  const file = join(dist, path === '/' ? 'index.html' : normalize(path));
  if (!path.startsWith('/api/') && file.startsWith(dist) && existsSync(file)) {
    response.writeHead(200, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream' }).end(readFileSync(file));
    return;
  }
  const headers = { ...request.headers, host: upstream };
  if (headers.origin !== undefined) headers.origin = `http://${upstream}`;
  const inner = ask({ host, port: hostPort, method: request.method, path: request.url, headers }, (answer) => {
    response.writeHead(answer.statusCode, answer.headers);
    answer.pipe(response);
  });
  inner.on('error', () => response.writeHead(502).end());
  request.pipe(inner);
});
new WebSocketServer({ server, path: '/ws' }).on('connection', (socket, request) => {
  const inner = new WebSocket(`ws://${upstream}${request.url}`, { headers: { origin: `http://${upstream}` } });
  const waiting = [];
  socket.on('message', (data) => (inner.readyState === WebSocket.OPEN ? inner.send(data.toString()) : waiting.push(data.toString())));
  inner.on('open', () => waiting.forEach((text) => inner.send(text)));
  inner.on('message', (data) => socket.send(data.toString()));
  const end = () => {
    socket.close();
    inner.close();
  };
  for (const one of [socket, inner]) {
    one.on('close', end);
    one.on('error', end);
  }
});
server.listen(port, '127.0.0.1', () => console.log(`http://127.0.0.1:${port}/ before ${upstream}`));
