/* A picture on paper: as large as there is room, or as its scale says. */
:- module(test_sheet, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(picture/contour), [line_ends/4]).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(picture/view)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(sheet/sheet)).
:- use_module(rules(store)).

%   corners(Box, Options, Sheet, Corners): where sheet_place/5 lays the lower
%   left and the upper right corner of a picture.

corners(box(X,Y,HalfW,HalfH), Options, Sheet, Corners) :-
    sheet_place(box(X,Y,HalfW,HalfH), 200-100, Options, Sheet, Place),
    X1 is X-HalfW,
    Y1 is Y-HalfH,
    X2 is X+HalfW,
    Y2 is Y+HalfH,
    placed_part(Place, part(visible,crease,1,1,0.0,1.0,X1-Y1,X2-Y2), Part),
    Part = part(visible,crease,1,1,0.0,1.0,Corner1,Corner2),
    Corners = Corner1/Corner2.

%   drawn(Name, Parts): a model as it is seen from somewhere.

drawn(Name, Goal) :-
    absolute_file_name(sanggwan(Name), File),
    new_world(World),
    in_world(World,
             ( load_model(File),
               complete_segments,
               set_view(33, 47, 0),
               picture([]),
               Goal )).

:- meta_predicate drawn(+, 0).

:- begin_tests(sheet).

test(fills, [ forall(member(Box-Options-Corners,
       [ % twice as wide as high: both margins are a tenth of the height
         box(3,4,9,4)-[]-((10000-90000)/(190000-10000)),
         box(3,4,18,4)-[]-((10000-70000)/(190000-30000)),
         box(3,4,4,8)-[]-((80000-90000)/(120000-10000)),
         box(3,4,8,4)-[margin(30)]-((60000-70000)/(140000-30000)),
         % no more than leaves a fifth of the shorter side
         box(3,4,8,4)-[margin(45)]-((80000-60000)/(120000-40000)),
         box(3,4,8,4)-[margin(-5)]-((0-100000)/(200000-0)),
         box(3,4,8,4)-[size(40-60)]-((4000-38000)/(36000-22000)),
         box(3,4,8,4)-[size('40x60')]-((4000-38000)/(36000-22000)),
         % as much as there is of an extent
         box(3,4,0,4)-[]-((100000-90000)/(100000-10000)),
         box(3,4,8,0)-[]-((10000-50000)/(190000-50000)),
         box(3,4,0,0)-[]-((100000-50000)/(100000-50000)) ])),
              true(Found == Corners) ]) :-
    corners(Box, Options, _, Found).
test(scale_of_a_point, Scale == 1.0) :-
    corners(box(3,4,0,0), [], sheet(200000,100000,Scale), _).
test(to_scale, Sheet-Corners == sheet(52000,36000,2.0)
                               -((10000-26000)/(42000-10000))) :-
    corners(box(3,4,8,4), [scale(2)], Sheet, Corners).
test(to_scale_with_margin, Sheet == sheet(33000,17000,2.0)) :-
    corners(box(3,4,8,4), [scale(2),margin(0.5)], Sheet, _).
test(to_scale_on_paper, Corners == ((34000-58000)/(66000-42000))) :-
    corners(box(3,4,8,4), [scale(2),size(100-100)], sheet(100000,100000,2.0),
            Corners).
%   It fits to the last thousandth, not beyond.
test(just_fits, Sheet == sheet(32000,16000,2.0)) :-
    corners(box(3,4,8,4), [scale(2),size(32-16)], Sheet, _).
test(too_small, [ forall(member(Size, [31.9-16,32-15.9])),
                  error(usage_error(sheet(size(Size, 32.0-16.0))), _) ]) :-
    corners(box(3,4,8,4), [scale(2),size(Size)], _, _).
test(no_scale, [ forall(member(Scale, [0,-1])),
                 error(domain_error(positive_scale, Scale), _) ]) :-
    corners(box(3,4,8,4), [scale(Scale)], _, _).
test(sizes, [ forall(member(Size, [0.001-0.001,100 000-5,5-100 000,
                                   '7 x 8.5'])) ]) :-
    corners(box(3,4,8,4), [size(Size)], _, _).
test(no_size, [ forall(member(Size, [0.0009-5,5-0.0009,100 001-5,5-100 001,
                                     a-5,5-a,'5','5x','x5','5x6x7','axb',f(x),
                                     '-5x6'])),
                error(domain_error(sheet_size, Size), _) ]) :-
    corners(box(3,4,8,4), [size(Size)], _, _).

%   Parts that go to the end of a line end exactly there.
test(ends, [ forall(member(Name, ['facts/two_cubes.pl','facts/cube.pl'])),
             true(Counts == [yes,yes]) ]) :-
    drawn(Name,
          ( picture_parts(Parts),
            findall(From-To,
                    ( member(part(_,_,S,E,From,To,A,B), Parts),
                      line_ends(S, E, P, Q),
                      \+ ( ( From =:= 0.0 -> A == P ; A \== P ),
                           ( To =:= 1.0 -> B == Q ; B \== Q ) ) ),
                    Wrong),
            assertion(Wrong == []),
            ( member(part(_,_,_,_,_,1.0,_,_), Parts) -> Some = yes
            ; Some = no ),
            ( Parts = [_|_] -> All = yes ; All = no ) )),
    Counts = [Some,All].

test(scaled, Scaled == drawing(sheet(3000,1500,5.0),
                 [view(front,
                       [stroke(visible,crease,1,[2],[0-3,15-8],joint,cut)],
                       [text(3,5,6,end,"x")])])) :-
    scaled_drawing(2.5,
        drawing(sheet(1200,600,2.0),
                [view(front,
                      [stroke(visible,crease,1,[2],[0-1,6-3],joint,cut)],
                      [text(1,2,2.4,end,"x")])]), Scaled).

:- end_tests(sheet).
