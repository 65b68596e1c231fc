:- module(sg_scan_line_drawing,
          [ scan_line_drawing/3         % +Scene, +Y, -Drawing
          ]).
:- use_module('../shading/seen',
              [depth_at/3, line_spans/3, slice_candidate/4]).
:- use_module('../shading/shading_scene', [scene_leaf/2, scene_size/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists),
              [append/2, append/3, max_list/2, member/2, min_list/2]).
/** <module> One scan line of a shaded picture, seen from above.

What the plane of the line cuts out of the faces of the leaves (slice/3), X to
the right as in the picture, depth upwards: the eye is below. The paper's figure
5 is such a drawing.

@see row CB-7
*/

%!  scan_line_drawing(+Scene, +Y, -Drawing) is det.
%
%   Drawing (sheet.pl), as wide as a sheet of 210 mm, has the slices of the line
%   Y of Scene, in dots. Of role `construction` are those that are never seen,
%   `outline` the candidates (slice_candidate/4), `penetration` what is seen.
%
%   @error domain_error(scan_line, Y)

scan_line_drawing(Scene, Y, drawing(sheet(Width,Height,Scale),
                                    [view('',Strokes,[])])) :-
    findall(Candidate-Slice, slice_candidate(Scene, Y, Slice, Candidate),
            Slices),
    line_spans(Scene, Y, Spans),
    findall(line(Role,S,Points),
            ( of_role(Role, Slices, Spans, slice(_,Leaf,_,_,X1,X2,Depth)),
              leaf_segment(Scene, Leaf, S),
              way_points(X1, X2, Depth, Points) ),
            Lines),
    scene_size(Scene, W-_),
    Width = 210000,
    Scale is 210.0/W,
    margin(Margin),
    depth_range(Lines, Low, High),
    Height is round((High-Low)*Scale*1000) + 2*Margin,
    maplist(line_stroke(at(Scale,High,Margin)), Lines, Strokes).

margin(10000).

%   of_role(Role, Slices, Spans, Slice) is nondet: in painting order.

of_role(construction, Slices, _, Slice) :-
    member(false-Slice, Slices).
of_role(outline, Slices, _, Slice) :-
    member(true-Slice, Slices).
of_role(penetration, Slices, Spans, slice(R,S,F,Sense,X1,X2,Depth)) :-
    member(span(N1,N2,R,S,F), Spans),
    Left is N1/256.0,
    Right is N2/256.0,
    ring_ends(Slices, slice(R,S,F), Left, Right, Ends),
    sort([Left,Right|Ends], Cuts),
    append(_, [X1,X2|_], Cuts),
    Middle is (X1+X2)/2,
    findall(Z-slice(R,S,F,Sense0,X1,X2,Depth0),
            ( member(true-slice(R,S,F,Sense0,From,To,Depth0), Slices),
              From =< Middle,
              Middle < To,
              depth_at(Depth0, Middle, Z) ),
            Candidates),
    keysort(Candidates, [_-slice(_,_,_,Sense,_,_,Depth)|_]).

%   ring_ends(Slices, Of, Left, Right, Ends): a span goes on from one slice of a
%   torus to the next at these places.

ring_ends(Slices, slice(R,S,F), Left, Right, Ends) :-
    findall(End,
            ( member(true-slice(R,S,F,_,From,To,Depth), Slices),
              functor(Depth, ring, _),
              member(End, [From,To]),
              Left < End,
              End < Right ),
            Ends).

leaf_segment(Scene, Leaf, S) :-
    once(scene_leaf(Scene, leaf(Leaf,_,S,_,_))).

%   way_points(X1, X2, Depth, Points): of a slice, X-Z in dots. An arc has its
%   points closer where it is steep, at its ends.

way_points(X1, X2, Depth, Points) :-
    (   functor(Depth, line, _)
    ->  Steps = 1
    ;   Steps = 48
    ),
    findall(X-Z,
            ( between(0, Steps, I),
              X is (X1+X2)/2 - (X2-X1)/2*cos(pi*I/Steps),
              depth_at(Depth, X, Z) ),
            Points).

depth_range(Lines, Low, High) :-
    findall(Z, ( member(line(_,_,Points), Lines), member(_-Z, Points) ), Zs),
    (   Zs == []
    ->  Low = 0.0,
        High = 0.0
    ;   min_list(Zs, Low),
        max_list(Zs, High)
    ).

line_stroke(At, line(Role,S,Points0),
            stroke(visible,Role,S,[],Points,joint,joint)) :-
    maplist(sheet_point(At), Points0, Points).

sheet_point(at(Scale,High,Margin), X0-Z, X-Y) :-
    X is round(X0*Scale*1000),
    Y is round((High-Z)*Scale*1000) + Margin.
