// The page: what is set goes to the solver each frame, and its answer into words, numbers and the picture.
import type { Maneuver, MaxSteerRun, Pose, Snug } from "snug";
import { createAnswers } from "./answers";
import { createChoices, usualSlot } from "./choices";
import { nearest, obstaclesOf, type Obstacle } from "./distance";
import { byId, set, setText } from "./dom";
import { createDrawing } from "./drawing";
import { createFields } from "./fields";
import { carCorners, clamp, corners, entryPose, track } from "./geometry";
import { commandLine, drivingOf, fromLink, slotOf, tidyPose, toLink, within, type Inputs } from "./inputs";
import { later } from "./later";
import { createMaps } from "./maps";
import { createParking } from "./parking";
import { createPlayer } from "./player";
import { asker, type Asker } from "./questions";
import { createSceneFile } from "./scene_file";
import { createShare } from "./share";
import { createShorter } from "./shorter";
import { compile, start } from "./solver";
import { createStreet } from "./street";
import { sayAnswer, sayHeading, sayPark } from "./words";

function run(snug: Snug, questions: Asker) {
    const groups = [
        { title: "Of the paper", cars: snug.cars() },
        { title: "Of data sheets", cars: snug.sheetCars().map(({ sheet: _, circle: __, ...car }) => car) },
    ];
    const catalogue = groups.flatMap(({ cars }) => cars);
    /** What a link leaves out. */
    const usual: Inputs = {
        mode: "street",
        way: "in",
        car: catalogue.find((car) => car.name === "renault-zoe")!,
        length: 4.9,
        width: 2.0,
        side: "right",
        frontSetback: 0,
        rearSetback: 0,
        curb: "high",
        angle: 0,
        road: 6,
        clearance: 0,
        enter: "backward",
        strategy: "max-steer",
        heading: null,
        pose: null,
        scene: null,
    };
    let inputs = usual;
    /** The car with rounded corners has an outline, which the library finds. */
    let rounded: { from: Inputs["car"] | null; car: Inputs["car"] } = { from: null, car: usual.car };
    const asked = (): Inputs => {
        const { corner_radius, ...own } = inputs.car;
        if (!corner_radius) return inputs;
        if (rounded.from !== inputs.car) rounded = { from: inputs.car, car: snug.car({ ...own, corner_radius }) };
        return { ...inputs, car: rounded.car };
    };
    const inStreet = () => inputs.mode === "street";
    const now = () => inputs;
    /** With the pose the car really has. */
    const standing = (): Inputs => (inStreet() ? { ...inputs, pose: inputs.pose ?? parking.state.pose } : inputs);

    let due = false;
    const refresh = () => {
        if (due) return;
        due = true;
        requestAnimationFrame(() => due && frame());
    };
    /** A heading belongs to its question: another question begins at the best one again. */
    const change = (next: Inputs) => {
        const sameQuestion = (Object.keys(usual) as (keyof Inputs)[]).every((key) => key === "heading" || next[key] === inputs[key]);
        inputs = sameQuestion || next.heading !== inputs.heading ? next : { ...next, heading: null };
        refresh();
    };

    const drawing = createDrawing(byId<SVGSVGElement>("drawing"), {
        length: (value) => change({ ...inputs, length: within("length", value) }),
        width: (value) => change({ ...inputs, width: within("width", value) }),
        heading: (value) => change({ ...inputs, heading: value }),
        released: () => {
            askRanges(asked());
            refresh();
        },
    });
    const street = createStreet(byId<SVGSVGElement>("street"), {
        pose: (pose) => change({ ...inputs, pose }),
        along: (by, front) => {
            const key = inputs.angle === 0 ? "length" : "width";
            const scale = inputs.angle === 0 ? 1 : Math.sin((inputs.angle * Math.PI) / 180);
            const value = within(key, inputs[key] + by * scale);
            // The front neighbour carries the origin: what stands still moves against it.
            const moved = front ? (value - inputs[key]) / scale : 0;
            const pose = inputs.pose && tidyPose({ ...inputs.pose, x: inputs.pose.x - moved });
            change({ ...inputs, [key]: value, pose });
        },
        depth: (by) => {
            const key = inputs.angle === 0 ? "width" : "length";
            const scale = inputs.angle === 0 ? 1 : 1 / Math.sin((inputs.angle * Math.PI) / 180);
            change({ ...inputs, [key]: within(key, inputs[key] + by * scale) });
        },
        road: (by) => inputs.road !== null && change({ ...inputs, road: within("road", inputs.road + by) }),
        grabbed: () => player.pause(),
        released: () => {
            if (due) frame();
            parking.released();
            refresh();
        },
    });
    const player = createPlayer((pose, steer) => (inStreet() ? street : drawing).showCar(pose, steer));
    // A field that is not the pose leaves the usual one as it is.
    const fields = createFields(standing, (next) => change(next.pose === parking.state.pose ? { ...next, pose: inputs.pose } : next));
    const choices = createChoices(groups, now, change);
    const shorter = createShorter(questions);
    const { answers, frameTimes, ask, askRanges, final } = createAnswers(snug, questions, {
        changed: refresh,
        settled: () => shorter.ask(asked(), final(inputs)?.direction_changes),
        failed: (sentence) => trouble(sentence),
        busy: () => drawing.busy() || maps.busy(),
    });
    const parking = createParking(snug, questions, {
        changed: refresh,
        answered: () => frame(),
        busy: () => street.busy(),
        slice: (heading) => (byId<HTMLInputElement>("show-map").checked ? street.slice(heading, street.busy() ? 10 : 5) : null),
    });
    const maps = createMaps(questions, (extraLength, extraWidth) => {
        const { car } = inputs;
        change({
            ...inputs,
            length: within("length", car.front + car.rear + extraLength),
            width: within("width", car.width + extraWidth),
        });
    });
    const answer = () => (inStreet() ? parking.state.exact : final(inputs));
    let moves: number | undefined;
    // The command leaves from nowhere unless it is told from where.
    const share = createShare(now, answer, () => commandLine(inputs.way === "out" ? standing() : inputs, moves));
    for (const id of ["swept", "tracks", "show-map"]) byId(id).addEventListener("change", refresh);
    // A button that goes leaves the keyboard's place with the answer.
    const button = (id: string, next: () => Inputs) =>
        byId(id).addEventListener("click", () => {
            change(next());
            byId("answer").focus({ preventScroll: true });
        });
    button("best", () => ({ ...inputs, heading: null }));
    button("usual", () => ({ ...inputs, pose: null }));
    button("try-all", () => ({ ...inputs, strategy: "fewest" }));
    button("fit-slot", () => ({ ...inputs, ...usualSlot(inputs.car, inStreet() ? inputs.angle : 0, inputs.clearance) }));
    button("close-scene", () => ({ ...inputs, scene: null, pose: null }));
    createSceneFile(snug, {
        opened: (scene) => change({ ...inputs, mode: "street", way: "in", scene, pose: null }),
        failed: (sentence) => {
            complaints = [sentence];
            trouble("");
        },
    });

    const soonLink = later(300);
    let linked = "";
    function frame() {
        due = false;
        const mine = inStreet();
        document.documentElement.dataset.mode = inputs.mode;
        // What belongs to one mode, and what a place from a file has not.
        const given = mine && !!inputs.scene;
        for (const element of document.querySelectorAll<HTMLElement>("[data-for], [data-of]"))
            element.toggleAttribute("hidden", (element.dataset.for ?? inputs.mode) !== inputs.mode || (given && element.dataset.of === "street"));
        byId("drawing").toggleAttribute("hidden", mine);
        byId("street").toggleAttribute("hidden", !mine);
        set(byId("scene-open"), { hidden: given ? null : "" });
        try {
            if (mine) {
                parking.ask(asked());
                presentStreet();
            } else {
                if (ask(asked())) shorter.wait();
                const { car, heading } = asked();
                present(heading === null ? null : snug.maxSteer(car, slotOf(inputs), heading, drivingOf(inputs)));
                maps.show(asked());
            }
            trouble("");
        } catch (error) {
            trouble(error instanceof Error ? error.message : String(error));
            return;
        }
        fields.show();
        choices.show();
        share.show();
        const link = `#${toLink(inputs)}`;
        if (link === linked) return;
        linked = link;
        // A link that was followed meanwhile has the last word.
        const before = location.hash;
        soonLink(() => {
            if (location.hash === before) history.replaceState(null, "", link);
        });
    }

    /** The car that is played, whatever is typed meanwhile. */
    const near = (car: Inputs["car"], obstacles: Obstacle[]) => (pose: Pose) =>
        nearest(carCorners(car, pose), corners({ ...car, front: car.wheelbase, rear: 0 }, pose), obstacles);

    let loaded: unknown = null;
    const load = (key: unknown, played: Parameters<typeof player.load>[0], otherwise?: string) => {
        if (loaded !== key || !played) {
            loaded = key;
            player.load(played, otherwise);
        } else player.place();
    };

    function presentStreet() {
        const { state, map } = parking;
        const { car } = asked();
        const swept = map.state();
        const found: Pick<Maneuver, "moves"> | null | undefined = parking.way();
        const shown = found && found.moves.length > 0 ? found : null;
        const way = shown ? track(shown, "right") : null;
        const { length, width, angle, road, side, enter, scene } = inputs;
        const blocked = state.bounds?.where === "blocked";
        street.render({
            car,
            place: state.scene,
            street: scene ? null : { length, width, angle: angle * (Math.PI / 180), road, left: side === "left", forward: enter === "forward", out: inputs.way === "out" },
            clearance: inputs.clearance,
            pose: state.pose,
            track: blocked ? null : way,
            blocked,
            painted: byId<HTMLInputElement>("show-map").checked ? state.painted : null,
            stale: !swept?.current,
            swept: byId<HTMLInputElement>("swept").checked,
            tracks: byId<HTMLInputElement>("tracks").checked,
        });
        const end = inputs.way === "out" && !scene ? "Out" : "Parked";
        const none = found && found.moves.length === 0 ? end : blocked || state.exact || state.bounds?.impossible ? undefined : "Searching …";
        if (state.exact || state.lookedAt === state.pose)
            load(shown, shown && way && { car, maneuver: shown, track: way, mirrored: false, end, near: near(car, obstaclesOf(state.scene)) }, none);
        if (!shown || (!state.exact && state.lookedAt !== state.pose)) street.showCar(state.pose, 0);
        parking.again();
        sayPark(snug, asked(), state, swept?.current ? swept : null);
        byId("legend-entries").toggleAttribute("hidden", !!scene || angle > 0 || inputs.way === "out");
        byId("street-legend").toggleAttribute("hidden", !byId<HTMLInputElement>("show-map").checked);
    }

    function present(run: MaxSteerRun | null) {
        const { length, width, clearance, side, strategy } = inputs;
        const { car } = asked();
        const forward = inputs.enter === "forward";
        const best = (strategy === "fewest" && answers.fewest?.maneuver) || answers.entry?.maneuver;
        const shown = run ? run.maneuver : best;
        moves = run?.outcome === "parked" ? run.maneuver?.direction_changes : undefined;
        const turned = (side === "left" ? -1 : 1) * (forward ? -1 : 1) * (shown?.entry.heading ?? 0);
        const heading = inputs.heading ?? clamp(turned, 0, Math.PI / 2);
        const way = shown ? track(shown, side) : null;
        drawing.render({
            car,
            length,
            width,
            frontSetback: inputs.frontSetback,
            rearSetback: inputs.rearSetback,
            low: inputs.curb === "low",
            left: side === "left",
            forward,
            clearance,
            heading,
            ranges: answers.fewest && !run ? [] : answers.ranges, // full steering's
            track: way,
            parked: run ? run.outcome === "parked" : true,
            swept: byId<HTMLInputElement>("swept").checked,
        });
        const far = 100;
        const box = (x1: number, x2: number, y1: number, y2: number) => [{ x: x1, y: y1 }, { x: x2, y: y1 }, { x: x2, y: y2 }, { x: x1, y: y2 }];
        const obstacles: Obstacle[] = [
            { corners: box(0, far, -far, -inputs.frontSetback), low: false, name: "front neighbour" },
            { corners: box(-far, -length, -far, -inputs.rearSetback), low: false, name: "rear neighbour" },
            { corners: box(-far, far, -far, -width), low: inputs.curb === "low", name: "curb" },
        ];
        const end = run && run.outcome !== "parked" ? "Stuck" : "Parked";
        load(shown, shown && way ? { car, maneuver: shown, track: way, mirrored: side === "left", end, near: near(car, obstacles) } : null);
        if (!shown) drawing.showCar(entryPose(car, length, heading, forward, clearance), 0);
        sayAnswer(snug, asked(), answers, shown, run);
        sayHeading(asked(), answers, shown, run, heading);
    }

    // What is wrong with a link is said next to the field it means, else at the top.
    let complaints: string[] = [];
    function trouble(sentence: string) {
        const all = [...complaints, sentence].filter(Boolean).join(" ");
        setText(byId("trouble"), all);
        set(byId("trouble"), { hidden: all ? null : "" });
    }
    byId("inputs").addEventListener("input", () => (complaints = []));
    const follow = () => {
        const link = fromLink(location.hash.slice(1), usual, catalogue, (text) => snug.readScene(text, "the place in the link"));
        linked = "";
        inputs = link.inputs;
        complaints = link.complaints.filter(({ field }) => !field).map(({ sentence }) => sentence);
        frame();
        for (const { field, sentence } of link.complaints) if (field) fields.complain(field, sentence);
    };
    window.addEventListener("hashchange", follow);

    follow();
    document.documentElement.dataset.ready = String(Math.round(performance.now()));
    // For the tests of the page.
    Object.assign(window, {
        snugPage: { snug, frameTimes, inputs: now, asked, answer, parking: parking.state, times: parking.times, map: parking.map },
    });
}

async function begin() {
    if (typeof WebAssembly !== "object") throw new Error("This page needs a browser with WebAssembly; any from spring 2023 on has it.");
    let questions: Asker;
    let snug: Snug;
    try {
        const module = await compile();
        questions = asker(module); // its first worker starts meanwhile
        snug = await start(module);
    } catch (error) {
        throw new Error(`The solver could not be started here: ${error instanceof Error ? error.message : String(error)}. Any browser from spring 2023 on runs it.`);
    }
    run(snug, questions);
}

begin().catch((error: unknown) => {
    const trouble = byId("trouble");
    document.documentElement.dataset.broken = "";
    setText(trouble, error instanceof Error ? error.message : String(error));
    trouble.hidden = false;
});
