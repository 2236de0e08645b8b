# A thin front: every target sets itself up, then CMake's presets do the work.
.PHONY: build python demo test fuzz soak bench package peers pictures docs web web-page web-test coverage format clean setup check-format check-tidy
.NOTPARALLEL:

JOBS := $(shell nproc)
SOURCES = $(shell find . -path ./build -prune -o -path ./out -prune -o -path ./web/node_modules -prune -o -name '*.[ch]pp' -print)

build: setup
	cmake --preset release
	cmake --build --preset release --parallel $(JOBS)

# Solves a slot, prints the answer, writes a picture.
demo: setup
	cmake --preset release
	cmake --build --preset release --parallel $(JOBS) --target snug_cli snug_manual
	@mkdir -p out
	build/release/snug entry --car mid-size --length 5.1 --width 2.2 --draw out/demo.svg
	@echo "The picture is out/demo.svg"

# Everything that can fail, the quickest first. One test more than there are cores, for some of them wait. The page is built and
# tested beside the build with sanitizers, for its tests mostly wait; what they say is in build/web/tests.log.
TESTS := $(shell expr $(JOBS) + 1)
test: check-format check-tidy build
	ctest --preset release --parallel $(TESTS)
	cmake --preset sanitize
	@mkdir -p build/web
	@echo "The page is built and tested beside this build: build/web/tests.log"
	@$(MAKE) web-test >build/web/tests.log 2>&1 & page=$$!; trap 'kill $$page' INT TERM; \
	    cmake --build --preset sanitize --parallel $(JOBS); built=$$?; \
	    wait $$page || { cat build/web/tests.log; exit 1; }; exit $$built
	ctest --preset sanitize --parallel $(TESTS)
	ctest --preset sanitize-command --parallel $(TESTS)
	cmake --preset threads
	cmake --build --preset threads --parallel $(JOBS)
	ctest --preset threads --parallel $(TESTS)

# The random checks with their full number.
soak: build
	ctest --preset soak --parallel $(JOBS)
	$(MAKE) fuzz RUNS=200000

# Readers and solver fed by libFuzzer.
RUNS := 20000
fuzz: setup
	cmake --preset sanitize
	cmake --build --preset fuzz --parallel $(JOBS)
	sh tests/fuzz/run.sh build/sanitize/tests/fuzz $(RUNS)

# Which lines the tests of the libraries run, with a tenth of their sample: build/coverage/index.html, and a table.
coverage: setup
	@setup/install.sh coverage-packages.txt
	cmake --preset coverage
	cmake --build --preset coverage --parallel $(JOBS)
	ctest --preset coverage --parallel $(JOBS)
	gcovr --root . --object-directory build/coverage --filter '(src|include|baselines|sentences|io|draw|sweep|drive|atlas|cli|paper)/' \
	    --exclude-throw-branches --html-details build/coverage/index.html --print-summary

# What it measures is kept as CSV, a file for each processor.
PROCESSOR := $(shell sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1 | tr -cs '[:alnum:]\n' '-')
bench: setup
	cmake --preset release
	cmake --build --preset release --parallel $(JOBS) --target snug_bench
	@mkdir -p bench/results
	build/release/snug_bench --benchmark_out=bench/results/$(or $(PROCESSOR),unknown).csv --benchmark_out_format=csv

# Two .deb: library, headers, command, manual and completions; snug-mpi. The manual is made last, by the command itself.
package: setup
	cmake --preset release
	cmake --build --preset release --parallel $(JOBS) --target snug_manual snug_mpi
	cpack --config build/release/CPackConfig.cmake -B build/package

# The Python package as a wheel: pip install --no-index --no-deps build/python/*.whl
python: setup
	cmake --preset release
	rm -rf build/python
	/usr/bin/python3 -m pip --quiet wheel --no-index --no-deps --no-build-isolation -w build/python bindings/python

# The pictures the README shows.
pictures: setup
	@setup/install.sh paper-packages.txt
	cmake --preset release
	cmake --build --preset release --parallel $(JOBS) --target snug_cli
	@mkdir -p docs/pictures build/pictures
	build/release/snug entry --car renault-zoe --length 4.5 --width 2.0 --draw docs/pictures/renault-zoe-4.5x2.0.png
	build/release/snug entry --car renault-zoe --length 4.8 --width 1.84 --strategy fewest \
	    --draw docs/pictures/renault-zoe-4.8x1.84-fewest.png
	build/release/snug park --car renault-zoe --length 5 --width 2.5 --angle 90 --road 6 \
	    --draw docs/pictures/park-perpendicular-2.5-6.0.png
	build/release/snug park --car renault-zoe --length 4.8 --width 2.0 --road 3.5 --from 2,1.75,0 \
	    --draw docs/pictures/park-parallel-4.8x2.0.png
	build/release/snug park --car renault-zoe --length 5 --width 2.3 --angle 90 --road 5 --enter forward --view map \
	    --draw docs/pictures/park-map-perpendicular-2.3-5.0-nose.png
	for car in mid-size renault-zoe opel-corsa vw-transporter mercedes-amg-gt; do for strategy in max-steer fewest; do \
	    build/release/snug min-slot --car $$car --extra-width 0.04:0.48:0.04 --max-changes 1,2,5,10 --strategy $$strategy \
	        $$(test $$strategy = fewest && echo --resolution 0.002) --format csv -o build/pictures/$$car-$$strategy.csv \
	        || exit; done; done
	/usr/bin/python3 paper/all_maneuvers.py build/pictures docs/pictures/minimum-slots.png
	/usr/bin/python3 docs/entry_ranges.py build/release/snug docs/pictures/entry-ranges.png
	$(MAKE) web-test
	cp build/web/page-desktop-light.png docs/pictures/page.png

# Every figure, table and claim of the paper again, in one report.
paper: setup
	@setup/install.sh paper-packages.txt
	cmake --preset release
	cmake --build --preset release --parallel $(JOBS) --target snug_cli
	build/release/snug paper --out build/paper
	/usr/bin/python3 paper/figures.py build/paper

# The documentation as one site, build/docs/html; a warning is an error.
docs: build
	@setup/install.sh docs-packages.txt
	@mkdir -p build/docs/reference
	doxygen docs/Doxyfile
	PYTHONPATH=build/release/bindings/python /usr/bin/sphinx-build -W --keep-going -q -b html -d build/docs/doctrees docs build/docs/html
	@echo "The documentation is build/docs/html/index.html"

# The page, built and served on this machine until it is interrupted; vite prints the address.
web: web-page
	cd web && npx vite preview

# The solver for the browser, build/wasm, and the page with it, web/dist. Emscripten finds its acorn among Debian's modules.
web-page: setup
	@setup/install.sh web-packages.txt
	@command -v npm >/dev/null || setup/install.sh npm-packages.txt
	NODE_PATH=/usr/share/nodejs emcmake cmake -S bindings/wasm -B build/wasm -G Ninja
	NODE_PATH=/usr/share/nodejs cmake --build build/wasm --parallel $(JOBS)
	cd web && { test node_modules/.package-lock.json -nt package-lock.json || npm install --no-save --no-audit --no-fund; }
	cd web && npm run build

# The page in Chromium, against the command. Its screenshots are in build/web.
web-test: web-page
	cmake --preset release
	cmake --build --preset release --parallel $(JOBS) --target snug_cli
	cd web && npm test

# snug beside OMPL: tests of its types for OMPL, an example, and planning to entry positions compared with planning to a
# parked pose (up to 8 minutes).
peers: setup
	@setup/install.sh peer-packages.txt
	cmake --preset peers
	cmake --build --preset peers --parallel $(JOBS)
	ctest --preset peers
	build/peers/peers

format: setup
	clang-format -i $(SOURCES)

clean:
	rm -rf build out web/dist

setup:
	@setup/install.sh

check-format: setup
	clang-format --dry-run -Werror $(SOURCES)

# Folders in one piece, as the sanitizers have them: most of the work is reading what they include. With ALL=1 not the core alone
# but all that is compiled, tests included (a quarter of an hour).
TIDY := $(if $(ALL),. -extra-arg=-Wno-shadow,'/snug\.dir/Unity|/(src|baselines)/')
check-tidy: setup
	cmake --preset tidy
	run-clang-tidy -quiet -j $(JOBS) -p build/tidy -extra-arg=-Wno-unknown-warning-option $(TIDY)
