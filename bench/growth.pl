/* How the time of a verb grows with the model:

       swipl -p foreign=build bench/growth.pl -- [FAMILY...]

   Each size is a run of build/sanggwan alone, three of them (or RUNS): the
   median of its seconds of processor, the most memory it had, the bytes it
   wrote, and the exponents of seconds and of bytes from the size before: no
   verb can grow slower than what it writes. What starting takes is taken off. A
   run that takes longer than LIMIT seconds (60 unless told) ends its family.
*/
:- multifile user:file_search_path/2.
:- prolog_load_context(directory, Bench),
   file_directory_name(Bench, Root),
   asserta(user:file_search_path(sanggwan, Root)),
   asserta(user:file_search_path(rules, sanggwan(rules))),
   asserta(user:file_search_path(tests, sanggwan(tests))).

:- use_module('../tests/rules/solid/grown').
:- use_module(library(apply)).
:- use_module(library(filesex), [delete_directory_and_contents/1]).
:- use_module(library(lists)).
:- use_module(library(process)).
:- use_module(library(readutil)).

:- initialization(main, main).

%   family(Name, Verb, Sizes): what is done with the model of each size.

family(wedges,     union, [800,1600,3200,6400]).
family(identical,  union, [1600,3200,12800,27500]).
family(apexes,     union, [500,1000,2000,4000]).
family(needles,    union, [1600,3200,6400,12800]).
family(comb,       union, [250,500,1000,2000]).
family(base,       union, [800,1600,3200,6400]).
family(stack,      union, [1000,2000,4000,8000]).
family(apart,      union, [1000,2000,4000,8000]).
family(row,        union, [1000,2000,4000,8000]).
family(identical,  check, [800,1600,3200,6400]).
family(base,       check, [800,1600,3200,6400]).
family(wedges,     check, [800,1600,3200,6400]).
family(row,        check, [1000,2000,4000,8000]).
family(apart,      check, [1000,2000,4000,8000]).
family(apart,      draw,  [1000,2000,4000]).
family(stack,      draw,  [250,500,1000]).
family(needles,    draw,  [800,1600,3200,6400]).
family(identical,  draw,  [400,800,1600,3200]).
family(base,       draw,  [400,800,1600,3200]).
family(wedges,     draw,  [400,800,1600,3200]).
family(apexes,     draw,  [250,500,1000]).
family(comb,       draw,  [500,1000,2000,4000]).
family(comb,       unfold, [50,100,200,400]).
family(holes,      draw,  [500,1000,2000,4000]).
family(circles,    check, [250,500,1000,2000]).
family(discs,      check, [250,500,1000,2000]).
family(rods,       penetrate, [400,800,1600,3200]).
family(rods,       union, [400,800,1600]).
family(boxes,      penetrate, [1000,2000,4000]).
family(chain,      penetrate, [500,1000,2000]).
family(chain,      split, [500,1000,2000,4000]).
family(cubes,      penetrate, [400,800,1600,3200]).
family(cubes,      draw,  [400,800,1600,3200]).
family(cubes,      union, [200,400,800]).
family(shells,     penetrate, [400,800,1600]).
family(shells,     draw,  [400,800,1600]).
family(shells,     union, [200,400,800]).
family(shells,     glue,  [50,100,200]).
family(touching,   glue,  [250,500,1000,2000]).
family(touching,   unfold, [125,250,500,1000]).
family(jobs,       batch, [100,400,1600]).
family(curves,     penetrate, [1600,3200,6400,12800]).
family(curves,     draw,  [1600,3200,6400,12800]).
family(boxes,      query, [2500,5000,10000]).
family(boxes,      check, [2500,5000,10000]).
family(boxes,      draw,  [1000,2000,4000]).
family(parts,      check, [1000,2000,4000]).
family(ball,       twice, [5000,10000,20000,40000]).
family(overlap,    union, [500,1000,2000,4000]).
family(nested,     check, [1000,2000,4000,8000]).
family(nested,     union, [1000,2000,4000,8000]).
family(rings,      check, [100,200,400,800]).
family(rings,      union, [100,200,400,800]).
family(rings,      draw,  [100,200,400,800]).
family(wedges,     render, [400,800,1600]).
family(nested,     render, [400,800,1600]).
family(row,        render, [1000,2000,4000]).
family(squares,    eval,  [500,1000,2000,4000]).
family(placings,   query, [1000,2000,4000,8000]).
family(copies,     eval,  [400,800,1600,3200]).
family(cylinder,   check, [1000,2000,4000]).
family(cylinder,   union, [1000,2000,4000]).
family(cylinder,   draw,  [1000,2000,4000]).
family(cylinder,   unfold, [500,1000,2000]).
family(folds,      unfold, [500,1000,2000]).

main :-
    current_prolog_flag(argv, Names),
    forall(( family(Name, Verb, Sizes),
             ( Names == [] ; memberchk(Name, Names) ) ),
           measured_family(Name, Verb, Sizes)).

measured_family(Name, Verb, Sizes) :-
    run_of([check,'-q','facts/cube.pl'], Start, _),
    format("~w ~w~n", [Verb,Name]),
    measured_sizes(Sizes, Name, Verb, Start, none).

measured_sizes([], _, _, _, _).
measured_sizes([N|Sizes], Name, Verb, Start, Before) :-
    model_file(Name, N, File),
    call_cleanup(medians(Verb, File, Seconds0, Memory, Bytes),
                 delete_file(File)),
    (   Seconds0 == none
    ->  format("~t~D~10|  longer than the limit~n", [N])
    ;   Seconds is max(0.001, Seconds0-Start),
        exponent(Before, size(N,Seconds,Bytes), Growth),
        format("~t~D~10| ~t~3f~19| s ~t~D~32| kB ~t~D~46| B  ~w~n",
               [N,Seconds,Memory,Bytes,Growth]),
        measured_sizes(Sizes, Name, Verb, Start, size(N,Seconds,Bytes))
    ).

exponent(none, _, '') :-
    !.
exponent(size(N0,S0,B0), size(N,S,B), Growth) :-
    Power is log(S/S0)/log(N/N0),
    (   B0 > 0,
        B > 0
    ->  Written is log(B/B0)/log(N/N0),
        format(atom(Growth), "n^~2f, written n^~2f", [Power,Written])
    ;   format(atom(Growth), "n^~2f", [Power])
    ).

medians(Verb, File, Seconds, Memory, Bytes) :-
    environment('RUNS', 3, N),
    findall(run(S,M,B),
            ( between(1, N, _), run_anew(Verb, File, S, M, B) ),
            Runs),
    (   length(Runs, N)
    ->  msort(Runs, Sorted),
        Middle is N//2,
        nth0(Middle, Sorted, run(Seconds,_,Bytes)),
        findall(M, member(run(_,M,_), Runs), Ms),
        max_list(Ms, Memory)
    ;   Seconds = none
    ).

%   run_anew(Verb, File, Seconds, Memory, Bytes) is semidet: what it writes is
%   deleted.

run_anew(Verb, File, Seconds, Memory, Bytes) :-
    verb_arguments(Verb, File, Arguments, Made),
    call_cleanup(
        ( run_of(Arguments, Seconds, Memory),
          (   last(Made, Out),
              exists_file(Out)
          ->  size_file(Out, Bytes)
          ;   Bytes = 0
          ) ),
        maplist(deleted, Made)).

deleted(File) :-
    (   exists_file(File)
    ->  delete_file(File)
    ;   exists_directory(File)
    ->  delete_directory_and_contents(File)
    ;   true
    ).

verb_arguments(check, File, [check,'-q',File], []).
verb_arguments(union, File, [union,'-q',File,Far,'-o',Out], [Far,Out]) :-
    output(off, Out),
    tmp_file_stream(Far, Stream, [extension(pl)]),
    format(Stream, "segment(1, solid, at([translate(-9,-9,-9)], \c
                    box(size(1,1,1)))).~n", []),
    close(Stream).
verb_arguments(eval, File, [eval,'-q',File,'-o',Out], [Out]) :-
    output(off, Out).
verb_arguments(draw, File, [draw,'-q',File,'-o',Out], [Out]) :-
    output(svg, Out).
verb_arguments(penetrate, File, [penetrate,'-q',File,'-o',Out], [Out]) :-
    output(pl, Out).
verb_arguments(split, File,
               [split,'-q',File,'--plane','1,2,3,100','-o',Out], [Out]) :-
    output(obj, Out).
verb_arguments(query, File,
               [ query,'-q','--limits','depth=100000,nodes=1000000',File,
                 'v(S, V, X, Y, Z)' ],
               []).
verb_arguments(render, File,
               [render,'-q','--size','320x200',File,'-o',Out], [Out]) :-
    output(png, Out).
verb_arguments(glue, File, [glue,'-q',File,'-o',Out], [Out]) :-
    output(pl, Out).
%   The bytes are those of the report.
verb_arguments(batch, File,
               [batch,'-q',File,'-o',Folder,'--report',Report],
               [Folder,Report]) :-
    tmp_file(growth, Folder),
    output(jsonl, Report).
verb_arguments(twice, File, [union,'-q',File,File,'-o',Out], [Out]) :-
    output(off, Out).
verb_arguments(unfold, File, [unfold,'-q',File,'-o',Out], [Out]) :-
    output(svg, Out).

output(Ending, File) :-
    tmp_file(growth, Base),
    file_name_extension(Base, Ending, File).

%   run_of(Arguments, Seconds, Memory) is semidet: of build/sanggwan; fails if
%   it takes longer than the limit. The code 1 of check is an answer.

run_of(Arguments, Seconds, Memory) :-
    environment('LIMIT', 60, Limit),
    append([timeout,Limit,'build/sanggwan'], Arguments, Command),
    process_create(path(bash),
                   [ '-c',
                     'exec /usr/bin/time -o /dev/fd/3 -f "%U %S %M" \c
                      "$@" 3>&1 >/dev/null 2>/dev/null',
                     bash | Command ],
                   [stdout(pipe(Out)), process(Pid)]),
    call_cleanup(read_string(Out, _, Text), close(Out)),
    process_wait(Pid, exit(Code)),
    Code =< 1,
    split_string(Text, "\n", " ", Lines0),
    exclude(==(""), Lines0, Lines),
    last(Lines, Line),
    split_string(Line, " ", "", Words),
    maplist([W,X]>>number_string(X, W), Words, [User,System,Memory]),
    Seconds is User+System.

%   environment(Name, Default, Number)

environment(Name, Default, Number) :-
    (   getenv(Name, Text)
    ->  atom_number(Text, Number)
    ;   Number = Default
    ).

%   model_file(Name, N, File): written anew.

model_file(parts, N, File) :-
    !,
    tmp_file_stream(File, Stream, [extension(stl)]),
    call_cleanup(forall(between(1, N, I), part(Stream, I)), close(Stream)).
model_file(Name, N, File) :-
    plane_family(Name, Step),
    !,
    tmp_file_stream(File, Stream, [extension(csg)]),
    call_cleanup(circles(Stream, N, Step), close(Stream)).
model_file(Name, N, File) :-
    grown_family(Name),
    !,
    tmp_file_stream(File, Stream, [extension(off)]),
    close(Stream),
    grown_file(Name, N, File, _).
model_file(Name, N, File) :-
    tmp_file_stream(File, Stream, [extension(pl)]),
    call_cleanup(segments(Name, N, Stream), close(Stream)).

grown_family(Name) :-
    clause(sg_test_grown:grown(Name, _, _, _), _),
    !.

%   A tetrahedron as a solid of its own.

part(Stream, I) :-
    X is 2*I,
    X1 is X+1,
    A = X-0-0, B = X1-0-0, C = X-1-0, D = X-0-1,
    format(Stream, "solid part~d~n", [I]),
    forall(member([P,Q,R], [[A,C,B],[A,B,D],[B,C,D],[C,A,D]]),
           ( format(Stream, "facet normal 0 0 0~nouter loop~n", []),
             forall(member(U-V-W, [P,Q,R]),
                    format(Stream, "vertex ~d ~d ~d~n", [U,V,W])),
             format(Stream, "endloop~nendfacet~n", []) )),
    format(Stream, "endsolid part~d~n", [I]).

%   N circles of 12 corners united, each over its neighbours or apart; or
%   squares apart.

plane_family(circles, plane(1.5, "circle($fn = 12, r = 1)")).
plane_family(discs, plane(2.5, "circle($fn = 12, r = 1)")).
plane_family(squares, plane(2, "square(size = [1, 1])")).

circles(Stream, N, plane(Step, Shape)) :-
    C is ceiling(sqrt(N)),
    format(Stream, "linear_extrude(height = 1) { union() {~n", []),
    forall(between(1, N, I),
           ( X is Step*(I mod C),
             Y is Step*(I//C),
             format(Stream, "multmatrix([[1, 0, 0, ~w], [0, 1, 0, ~w], \c
                             [0, 0, 1, 0], [0, 0, 0, 1]]) { ~s; }~n",
                    [X,Y,Shape]) )),
    format(Stream, "} }~n", []).

%   A plate with N triangular holes.
segments(holes, N, Stream) :-
    C is ceiling(sqrt(N)),
    M is C+1,
    findall([[X1,Y1],[X2,Y2],[X3,Y3]],
            ( between(1, N, I),
              X is I//C, Y is I mod C,
              X1 is X+0.1, Y1 is Y+0.1, X2 is X+0.7, Y2 is Y+0.2,
              X3 is X+0.3, Y3 is Y+0.8 ),
            Holes),
    format(Stream, "segment(1, solid, prism(outline(~w), holes(~w), \c
                    height(1))).~n",
           [[[-1,-1],[M,-1],[M,M],[-1,M]],Holes]).
%   A box in N placings.
segments(placings, N, Stream) :-
    format(Stream, "segment(1, solid, ", []),
    forall(between(1, N, _), write(Stream, 'at([translate(1,0,0)], ')),
    write(Stream, 'box(size(1,1,1))'),
    forall(between(1, N, _), write(Stream, ')')),
    format(Stream, ").~n", []).
%   N rods askew, each a segment.
segments(rods, N, Stream) :-
    forall(between(1, N, I),
           ( X is (I mod 40)*0.01,
             Y is (I//40)*0.01,
             format(Stream,
                    "segment(~d, solid, at([rotate(x,35), rotate(y,40), \c
                     translate(~w,~w,0)], box(size(0.002,0.002,10)))).~n",
                    [I,X,Y]) )).
%   N curves from one point, each a segment.
segments(curves, N, Stream) :-
    forall(between(1, N, I),
           ( A is 2*pi*I/N, X is cos(A), Y is sin(A),
             format(Stream,
                    "segment(~d, curve, line(from(0,0,0), to(~w,~w,1))).~n",
                    [I,X,Y]) )).
%   N boxes apart, each a segment.
segments(boxes, N, Stream) :-
    forall(between(1, N, I),
           ( X is 2*(I mod 40),
             Y is 2*(I//40),
             format(Stream,
                    "segment(~d, solid, at([translate(~w,~w,0)], \c
                     box(size(1,1,1)))).~n",
                    [I,X,Y]) )).
%   N boxes in a row, each a segment that touches the next one.
segments(touching, N, Stream) :-
    forall(between(1, N, I),
           format(Stream,
                  "segment(~d, solid, at([translate(~d,0,0)], \c
                   box(size(1,1,1)))).~n",
                  [I,I])).
%   No model, but a manifest: a cube drawn from N sides.
segments(jobs, N, Stream) :-
    absolute_file_name(sanggwan('facts/cube.pl'), Cube),
    format(Stream,
           "job(from(I), draw, [~q], [view(I,30), output('%.svg')]) \c
            @ I in 1..~d.~n",
           [Cube,N]).
%   One box N times, each a leaf of one tree.
segments(copies, N, Stream) :-
    forall(between(1, N, I),
           format(Stream, "segment(~d, solid, box(size(1,1,1))).~n", [I])),
    numlist(1, N, Is),
    Union is N+1,
    format(Stream, "segment(~d, solid, union(~w)).~n", [Union,Is]).
%   A cylinder on N corners, long and askew.
segments(cylinder, N, Stream) :-
    format(Stream, "segment(1, solid, at([rotate(x,35), rotate(y,40)], \c
                    prism(outline(", []),
    findall([X,Y],
            ( between(1, N, I), A is 2*pi*I/N, X is cos(A), Y is sin(A) ),
            Outline),
    format(Stream, "~w), height(50)))).~n", [Outline]).
%   N boxes askew, or coarse balls, in each other, each a segment.
segments(cubes, N, Stream) :-
    forall(between(1, N, I),
           ( R is 1.0+I/N,
             Z is -R/2,
             format(Stream,
                    "segment(~d, solid, at([translate(0,0,~w), \c
                     rotate(x,30), rotate(y,20)], \c
                     box(size(~w,~w,~w)))).~n",
                    [I,Z,R,R,R]) )).
segments(shells, N, Stream) :-
    forall(between(1, N, I),
           ( R is 1.0+I/N,
             format(Stream,
                    "segment(~d, solid, sphere(radius(~w), facets(8))).~n",
                    [I,R]) )).
%   N boxes, each through the next one.
segments(chain, N, Stream) :-
    forall(between(1, N, I),
           ( X is 0.75*I,
             Y is 0.25*(I mod 2),
             format(Stream,
                    "segment(~d, solid, at([translate(~w,~w,~w)], \c
                     box(size(1,1,1)))).~n",
                    [I,X,Y,Y]) )).
