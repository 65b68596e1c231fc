:- module(test_bresenham, []).
:- use_module(library(plunit)).
:- use_module(rules(drawing/bresenham)).
:- use_module(rules(kernel), [raster_dots/4]).

random_point(X-Y) :-
    random_between(-3, 42, X),
    random_between(-3, 32, Y).

random_chain(Seed, Points, Pattern) :-
    set_random(seed(Seed)),
    random_between(1, 6, N),
    length(Points, N),
    maplist(random_point, Points),
    random_member(Pattern, [[], [3,3], [1,1], [5,2,1,2], [1,7]]).

% The dots of the rule, as the kernel says it.
rule_dots(W, H, Points, Pattern, String) :-
    chain_dots(Points, Pattern, Dots),
    sort(Dots, Set),
    findall(Ink,
            ( between(1, H, Y1),
              between(1, W, X1),
              X is X1-1,
              Y is Y1-1,
              ( memberchk(X-Y, Set) -> Ink = 1 ; Ink = 0 )
            ),
            Inks),
    string_codes(String, Inks).

:- begin_tests(bresenham).

test(line, all(Dot == [0-0,1-0,2-1,3-1,4-2])) :-
    line_dot(0-0, 4-2, Dot).
test(last_is_det, true(Dot == 5-5)) :-
    line_dot(5-5, 5-5, Dot).
test(pattern_3, true(Xs == [0,1,2,6,7,8,12])) :-
    chain_dots([0-0,4-0,12-0], [3,3], Dots),
    findall(X, member(X-0, Dots), Xs).
test(point, true(Dots == [2-3])) :-
    chain_dots([2-3], [3,3], Dots).
test(nothing, true(Dots == [])) :-
    chain_dots([], [], Dots).
test(kernel, [ forall(between(1, 300, Seed)), true(Kernel == Rule) ]) :-
    random_chain(Seed, Points, Pattern),
    rule_dots(40, 30, Points, Pattern, Rule),
    raster_dots(40, 30, [stroke(1,1,Pattern,Points)], Kernel).

:- end_tests(bresenham).

:- begin_tests(raster).

% Sizes, strokes and palettes that are refused.
test(size, error(domain_error(raster_size, 0-5))) :-
    raster_dots(0, 5, [], _).
test(size, error(domain_error(raster_size, 20000-5))) :-
    raster_dots(20000, 5, [], _).
test(size, error(type_error(integer, a))) :-
    raster_dots(a, 5, [], _).
test(strokes, error(instantiation_error)) :-
    raster_dots(5, 5, _, _).
test(stroke, error(type_error(stroke, x))) :-
    raster_dots(5, 5, [x], _).
test(ink, error(domain_error(ink, 256))) :-
    raster_dots(5, 5, [stroke(256,1,[],[])], _).
test(pen, error(domain_error(pen, _))) :-
    raster_dots(5, 5, [stroke(1,0,[],[])], _).
test(pattern, error(domain_error(pen, _))) :-
    raster_dots(5, 5, [stroke(1,1,[3],[])], _).
test(pattern, error(type_error(not_less_than_one, 0))) :-
    raster_dots(5, 5, [stroke(1,1,[3,0],[])], _).
test(point, error(type_error(pair, p))) :-
    raster_dots(5, 5, [stroke(1,1,[],[1-1,p])], _).
test(far, error(domain_error(raster_coordinate, 2000000))) :-
    raster_dots(5, 5, [stroke(1,1,[],[2000000-1])], _).
test(none, true(Dots == "\000\\000\\000\\000\")) :-
    raster_dots(2, 2, [], Dots).
test(later_covers, true(Dots == "\002\\001\")) :-
    raster_dots(2, 1, [stroke(1,1,[],[0-0,1-0]),stroke(2,1,[],[0-0])], Dots).
test(png_dots, error(domain_error(raster_dots, "ab"))) :-
    sg_kernel:raster_png(5, 5, "ab", [rgb(0,0,0)], _).
test(palette, error(domain_error(palette, []))) :-
    sg_kernel:raster_png(1, 1, "\000\", [], _).
test(palette, error(type_error(rgb, white))) :-
    sg_kernel:raster_png(1, 1, "\000\", [white], _).
test(palette, error(domain_error(byte, 300))) :-
    sg_kernel:raster_png(1, 1, "\000\", [rgb(0,300,0)], _).
test(palette_too_short, error(domain_error(palette, [rgb(0,0,0)]))) :-
    sg_kernel:raster_png(1, 1, "\001\", [rgb(0,0,0)], _).
test(interrupt, true(Time < 1)) :-
    findall(X-0, ( between(1, 4000, I), X is (I mod 2)*2000000-1000000 ), Ps),
    get_time(T0),
    catch(call_with_time_limit(0.1, raster_dots(5, 5, [stroke(1,1,[],Ps)],
                                                _)),
          time_limit_exceeded, true),
    get_time(T1),
    Time is T1-T0.

:- end_tests(raster).
