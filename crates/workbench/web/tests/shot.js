// Takes a picture of the page: node tests/shot.js OUT WIDTHxHEIGHT HASH-AND-QUERY [wait ms] [script]
import { chromium } from '@playwright/test';
const [out, size = '1440x900', path = '', wait = '1500', script] = process.argv.slice(2);
const [width, height] = size.split('x').map(Number);
const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox'] });
const page = await browser.newPage({ viewport: { width, height }, deviceScaleFactor: 1 });
page.on('console', (message) => ['error', 'warning'].includes(message.type()) && console.log(message.type(), message.text()));
page.on('pageerror', (error) => console.log('PAGEERROR', error.message, error.stack?.split('\n')[1]));
await page.goto(`http://127.0.0.1:${process.env.PORT ?? 7301}/${path}`);
await page.waitForTimeout(Number(wait));
if (script !== undefined) { const r = await (new Function('page', `return (async () => { ${script} })()`))(page); if (r !== undefined) console.log(JSON.stringify(r)); await page.waitForTimeout(300); }
await page.screenshot({ path: out });
await browser.close();
