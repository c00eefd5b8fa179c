'use strict';
// One line of JSON for each check, and nothing else on standard output.

console.log = console.warn = () => {}; // Libraries talk too.

const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
const limit_ms = 20000;

/** Does something and compares what comes of it; `wanted` is a value, or a function that says whether a value is right. */
async function check(name, action, wanted) {
    let got;
    let timer;
    try {
        const late = new Promise((_, reject) => { timer = setTimeout(() => reject(new Error('no answer')), limit_ms); });
        got = await Promise.race([Promise.resolve().then(action), late]);
    } catch (error) {
        got = `${error && error.name ? error.name : 'error'}: ${error && error.message ? error.message : error}`;
    }
    clearTimeout(timer);
    if (Buffer.isBuffer(got)) got = got.toString('hex');
    const right = typeof wanted === 'function' ? wanted(got) : same(got, wanted);
    process.stdout.write(JSON.stringify({ check: name, ok: Boolean(right), got: got === undefined ? null : got }) + '\n');
    return got;
}

/** What is right is an error that says one of these words. */
const refused = (...words) => (got) => typeof got === 'string' && words.some((word) => got.toLowerCase().includes(word.toLowerCase()));

/** Says that a script came to its end. */
function end() {
    process.stdout.write(JSON.stringify({ check: 'end', ok: true, got: null }) + '\n');
    process.exit(0);
}

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/** What an action gives as soon as it is right; a scan may lie between. */
async function again(action, right) {
    for (let left = 100; ; left -= 1) {
        const got = await action();
        if (right(got) || left === 0) return got;
        await pause(20);
    }
}

module.exports = { check, refused, end, pause, again, same };
