// How long the built page takes: `npm run bench`, or `npm run bench -- street/angled` for some of it. Each line is
// <question>/<strategy>/<case> and milliseconds, then those of CPU: of the page's thread while something is dragged, else of all
// threads of the page until then. A busy machine makes the first larger, so nothing is asserted.
import { closeBrowser, open } from "./browser.mjs";

const site = await open();
const settled = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const line = (name, times, cpu = []) => {
    const told = (kind, of) => {
        if (of.length === 0) return "";
        const sorted = of.slice().sort((a, b) => a - b);
        const at = (part) => sorted[Math.floor((sorted.length - 1) * part)].toFixed(2).padStart(8);
        return `${kind}least ${at(0)} median ${at(0.5)} most ${at(1)}`;
    };
    console.log(`${name.padEnd(66)}${told("", times)}${told(times.length ? "   CPU " : "CPU ", cpu)} ms, of ${times.length || cpu.length}`);
};
/** CPU that the page's thread and all its threads have had. [ms] */
const clocks = async (page) => {
    const client = await page.context().newCDPSession(page);
    await client.send("Performance.enable");
    return async () => {
        const { metrics } = await client.send("Performance.getMetrics");
        const of = (name) => 1000 * metrics.find((one) => one.name === name).value;
        return { thread: of("ThreadTime"), process: of("ProcessTime") };
    };
};
/** Steps one after another, each drawn before the next; what each took of the page's thread. */
async function cpuOfSteps(page, clock, count, step) {
    const cpu = [];
    let before = (await clock()).thread;
    for (let i = 0; i <= count; ++i) {
        await step(i);
        await settled(page);
        const now = (await clock()).thread;
        cpu.push((now - before) / 2); // two frames
        before = now;
    }
    return cpu;
}

/** The rear neighbour dragged in and out; what each frame took to answer. */
async function drag(name, path) {
    const page = await site.page({ path });
    const clock = await clocks(page);
    await page.evaluate(() => (window.snugPage.frameTimes.length = 0));
    const grip = await page.locator('#drawing [data-grip="rear"] .knob').boundingBox();
    const [x, y] = [grip.x + grip.width / 2, grip.y + grip.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    const cpu = await cpuOfSteps(page, clock, 60, (step) => page.mouse.move(x + 60 * Math.sin(step / 6), y));
    line(name, await page.evaluate(() => window.snugPage.frameTimes), cpu);
    await page.mouse.up();
    await page.context().close();
}

/** From the navigation until everything can be used and there is an answer; the same in the street, until the map is there. */
async function load(name) {
    const [times, cpu, maps, cpuOfMaps] = [[], [], [], []];
    for (let i = 0; i < 5; ++i) {
        const page = await site.page();
        const clock = await clocks(page);
        cpu.push((await clock()).process);
        times.push(Number(await page.evaluate(() => document.documentElement.dataset.ready)));
        await page.waitForFunction(() => window.snugPage.times.answers.length > 0);
        cpuOfMaps.push((await clock()).process);
        maps.push(await page.evaluate(() => Number(document.documentElement.dataset.ready) + window.snugPage.times.answers[0]));
        await page.context().close();
    }
    line(`${name}/interactive`, times, cpu);
    line(`${name}/first-map-and-answer`, maps, cpuOfMaps);
}

/**
 * In the street: the car driven about, the look-ups in each frame, and after it is put down the time until a way is shown that
 * is checked by exact contact, and until one whose count is proved; a neighbour dragged, the frames meanwhile, and the time until
 * the answer where the car stands, and a checked way from there.
 */
async function street(name, path) {
    const page = await site.page({ path });
    const clock = await clocks(page);
    const rest = () => page.waitForFunction(() => window.snugPage.map.state()?.finest && window.snugPage.map.state().own && window.snugPage.answer());
    await rest();
    const times = ([of, which]) => page.evaluate(([of, which]) => (of === "map" ? window.snugPage.map.times : window.snugPage.times)[which], [of, which]);
    const held = async (what) => {
        await page.evaluate(() => scrollTo(0, 0));
        const box = await page.locator(`#street [data-grip="${what}"] ${what === "car" ? ".reach" : ".knob"}`).boundingBox();
        const at = [box.x + box.width / 2, box.y + box.height / 2];
        await page.mouse.move(...at);
        await page.mouse.down();
        return at;
    };
    /** Put down so many times, after so many frames of dragging; until one more `of` is told. */
    const puts = async (what, of, count, move, dragged = 0) => {
        const [cpu, took] = [[], []];
        await page.evaluate((of) => (window.snugPage.times[of].length = window.snugPage.times.ways.length = 0), of);
        for (let i = 0; i < count; ++i) {
            const [x, y] = await held(what);
            const before = (await clock()).process;
            for (let n = 0; n < dragged; ++n) {
                await page.mouse.move(...move(x - 10 * Math.sin(n), y, i));
                await settled(page);
            }
            const told = await page.evaluate((of) => window.snugPage.times[of].length, of);
            await page.mouse.move(...move(x, y, i));
            await page.mouse.up();
            await page.waitForFunction(([of, told]) => window.snugPage.times[of].length > told || window.snugPage.parking.bounds?.where === "blocked", [of, told]);
            cpu.push((await clock()).process - before);
            took.push(...(await page.evaluate(([of, told]) => window.snugPage.times[of].slice(told).slice(-1), [of, told])));
            await rest().catch(() => {});
        }
        return [took, cpu];
    };
    const [x, y] = await held("car");
    await page.evaluate(() => (window.snugPage.map.times.looks.length = window.snugPage.map.times.own.length = 0));
    const frames = await cpuOfSteps(page, clock, 60, (step) => page.mouse.move(x - 60 + 60 * Math.cos(step / 6), y + 30 * Math.sin(step / 6)));
    await page.mouse.up();
    await rest();
    line(`${name}/car-dragged/look-ups-in-the-frame`, await times(["map", "own"]), frames);
    line(`${name}/car-dragged/look-ups-by-a-worker`, await times(["map", "looks"]));
    const proof = await puts("car", "proofs", 8, (x, y, i) => [x + 24 * Math.cos(2.4 * i), y + 10 * Math.sin(2.4 * i)]);
    line(`${name}/car-put-down/checked-way`, await times(["times", "ways"]));
    line(`${name}/car-put-down/proved-way`, ...proof);

    const [rx, ry] = await held("rear");
    const wide = await cpuOfSteps(page, clock, 30, (step) => page.mouse.move(rx - 20 + 20 * Math.cos(step / 5), ry));
    await page.mouse.up();
    await rest();
    line(`${name}/neighbour-dragged`, [], wide);
    line(`${name}/map-taken-over`, await times(["map", "taken"]));
    const moved = await puts("rear", "answers", 10, (x, y, i) => [x + (i % 2 ? 5 : -5), y]);
    line(`${name}/neighbour-put-down/answer`, ...moved);
    line(`${name}/neighbour-put-down/checked-way`, await times(["times", "ways"]));
    const passed = await puts("rear", "answers", 10, (x, y, i) => [x + (i % 2 ? 5 : -5), y], 12);
    line(`${name}/neighbour-dragged-and-put-down/answer`, ...passed);
    line(`${name}/neighbour-dragged-and-put-down/checked-way`, await times(["times", "ways"]));
    line(`${name}/first-map`, await times(["map", "maps"]));
    await page.context().close();
}

const cases = [
    ["page/load", load],
    ["page/max-steer/drag-ordinary-slots", drag, "#mode=entry"],
    ["page/max-steer/drag-tight-slots", drag, "#car=renault-zoe&length=4.9&width=1.85"],
    ["page/street/parallel", street, "#mode=street&length=5.4"],
    ["page/street/parallel-tight", street, "#mode=street"],
    ["page/street/perpendicular", street, "#mode=street&angle=90&length=5&width=2.5"],
    ["page/street/angled", street, "#mode=street&angle=60&length=4.68&width=2.5"],
];
for (const [name, measured, path] of cases) if (name.includes(process.argv[2] ?? "")) await measured(name, path);
await site.close();
await closeBrowser();
