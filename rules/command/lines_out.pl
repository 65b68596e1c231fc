:- module(sg_lines_out,
          [ write_lines/1,              % +File
            write_lines/2,              % +File, +Options
            write_lines_to/3,           % +Stream, +Format, +Options
            line_format/1               % ?Format
          ]).
:- use_module('../penetration/chain', [chains/1, chain_points/2]).
:- use_module(lines_dxf, [write_lines_dxf/2]).
:- use_module('../output', [writing/3]).
:- use_module(point_table, [write_point_table/4]).
:- use_module('../picture/view', [current_view/4, eye_point/4]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(error), [domain_error/2]).
:- use_module(library(lists),
              [append/3, max_list/2, member/2, min_list/2, nth1/3, numlist/3]).
:- use_module(library(option), [option/3]).

/** <module> Penetration lines as files.

The chains of the current world (chain.pl), written as

  - `.pl`: a model file of curves, one segment for each chain, which can be
    read, drawn and cut again;
  - `.obj`: vertices and one `l` element for each chain, `p` for a contact in
    a point, in a group that names the two segments;
  - `.dxf`: polylines in space (lines_dxf.pl);
  - `.csv`, `.tsv`, `.txt`: a table of their points (point_table.pl);
  - `.svg`: what the current view shows of them.

Numbers are written with as many digits as it takes to read them back.
*/

%!  write_lines(+File) is semidet.
%!  write_lines(+File, +Options) is semidet.
%
%   Write the penetration lines to File. Options: format(F), one of
%   line_format/1, else the ending of File; size(Size) for svg, Width-Height or
%   WidthxHeight in mm (100x100); exact(true) for tables: coordinates as
%   fractions.
%
%   @error domain_error(line_format, Ending)

write_lines(File) :-
    write_lines(File, []).

write_lines(File, Options) :-
    file_name_extension(_, Ending, File),
    option(format(Format), Options, Ending),
    check_format(Format),
    writing(File, text, sg_lines_out:written(Format, Options)).

written(Format, Options, Stream) :-
    write_lines_to(Stream, Format, Options).

%!  write_lines_to(+Stream, +Format, +Options) is det.
%
%   The same to a stream that is open.

write_lines_to(Stream, Format, Options) :-
    check_format(Format),
    chains(Chains),
    write_chains(Format, Stream, Chains, Options).

%!  line_format(?Format) is nondet.
%
%   The endings of files that lines can be written to.

line_format(pl).
line_format(obj).
line_format(csv).
line_format(tsv).
line_format(txt).
line_format(svg).
line_format(dxf).

check_format(Format) :-
    (   ground(Format),
        line_format(Format)
    ->  true
    ;   domain_error(line_format, Format)
    ).

write_chains(pl, Out, Chains, _) :-
    write_model(Out, Chains).
write_chains(obj, Out, Chains, _) :-
    write_obj(Out, Chains).
write_chains(dxf, Out, Chains, _) :-
    write_lines_dxf(Out, Chains).
write_chains(csv, Out, Chains, Options) :-
    write_point_table(csv, Out, Chains, Options).
write_chains(tsv, Out, Chains, Options) :-
    write_point_table(tsv, Out, Chains, Options).
write_chains(txt, Out, Chains, Options) :-
    write_point_table(txt, Out, Chains, Options).
write_chains(svg, Out, Chains, Options) :-
    write_picture(Out, Chains, Options).

%   chain_shape(+Chain, -Points): of a closed chain without the last point,
%   which is the first again.

chain_shape(chain(_, _, Kind, Lines), Points) :-
    chain_points(Lines, All),
    (   Kind == closed
    ->  append(Points, [_], All)
    ;   Points = All
    ),
    !.

/* - - - facts - - - */

write_model(Out, Chains) :-
    format(Out, "% Penetration lines, one curve for each chain.~n", []),
    forall(nth1(C, Chains, Chain), write_curve(Out, C, Chain)).

write_curve(Out, C, Chain) :-
    Chain = chain(S1, S2, Kind, _),
    chain_shape(Chain, Points),
    length(Points, N),
    format(Out, "~nsegment(~d, curve, penetration(~d, ~d, ~w)).~n",
           [C, S1, S2, Kind]),
    forall(nth1(V, Points, point(X,Y,Z)),
           format(Out, "v(~d, ~d, ~w, ~w, ~w).~n", [C, V, X, Y, Z])),
    numlist(1, N, Vs0),
    (   Kind == closed
    ->  append(Vs0, [1], Vs)
    ;   Vs = Vs0
    ),
    format(Out, "curve(~d, ~w).~n", [C, Vs]).

/* - - - OBJ - - - */

write_obj(Out, Chains) :-
    format(Out, "# penetration lines~n", []),
    foldl(write_polyline(Out), Chains, 1-1, _).

write_polyline(Out, Chain, C0-V0, C-V) :-
    Chain = chain(S1, S2, Kind, _),
    chain_shape(Chain, Points),
    length(Points, N),
    format(Out, "g chain_~d_of_~d_and_~d~n", [C0, S1, S2]),
    forall(member(point(X,Y,Z), Points),
           format(Out, "v ~w ~w ~w~n", [X, Y, Z])),
    (   Kind == point
    ->  format(Out, "p", [])
    ;   format(Out, "l", [])
    ),
    C is C0+1,
    V is V0+N,
    Last is V-1,
    forall(between(V0, Last, I), format(Out, " ~d", [I])),
    (   Kind == closed
    ->  format(Out, " ~d~n", [V0])
    ;   nl(Out)
    ).

/* - - - picture - - - */

%   The lines alone, in parallel projection from where the view stands, scaled
%   to fill the sheet; no line hides another.

write_picture(Out, Chains, Options) :-
    option(size(Size), Options, 100-100),
    sheet_size(Size, Width, Height),
    maplist(chain_seen, Chains, Seen),
    picture_scale(Seen, Width, Height, Scale),
    format(Out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>~n", []),
    format(Out, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"~wmm\" \c
                 height=\"~wmm\" viewBox=\"0 0 ~w ~w\">~n",
           [Width, Height, Width, Height]),
    format(Out, "<rect width=\"~w\" height=\"~w\" fill=\"white\"/>~n",
           [Width, Height]),
    format(Out, "<g fill=\"none\" stroke=\"black\" stroke-width=\"0.35\" \c
                 stroke-linecap=\"round\" stroke-linejoin=\"round\">~n", []),
    forall(nth1(C, Seen, Chain), write_path(Out, Scale, C, Chain)),
    format(Out, "</g>~n</svg>~n", []).

sheet_size(Width-Height, Width, Height) :-
    !.
sheet_size(Size, Width, Height) :-
    split_string(Size, "x", "", [W,H]),
    number_string(Width, W),
    number_string(Height, H).

chain_seen(Chain, seen(S1, S2, Kind, Points)) :-
    Chain = chain(S1, S2, Kind, _),
    current_view(Theta, Phi, _, _),
    chain_shape(Chain, Points0),
    maplist(point_seen(Theta, Phi), Points0, Points).

point_seen(Theta, Phi, point(X,Y,Z), Xe-Ye) :-
    eye_point(Theta, Phi, p(X,Y,Z), p(Xe,Ye,_)).

%   picture_scale(+Seen, +Width, +Height, -Scale): Scale takes model units to
%   mm, with a margin of a twentieth.

picture_scale(Seen, Width, Height, scale(F, Xm, Ym, Xc, Yc)) :-
    findall(X, seen_point(Seen, X-_), Xs),
    findall(Y, seen_point(Seen, _-Y), Ys),
    range(Xs, Xm, Dx),
    range(Ys, Ym, Dy),
    Xc is Width/2,
    Yc is Height/2,
    (   Dx =:= 0, Dy =:= 0
    ->  F = 1.0
    ;   F is 0.9*min(Width/max(Dx, 1.0e-300), Height/max(Dy, 1.0e-300))
    ).

seen_point(Seen, Point) :-
    member(seen(_, _, _, Points), Seen),
    member(Point, Points).

range([], 0.0, 0.0) :-
    !.
range(Xs, Middle, Width) :-
    min_list(Xs, Low),
    max_list(Xs, High),
    Middle is (Low+High)/2,
    Width is float(High-Low).

write_path(Out, Scale, C, seen(S1, S2, Kind, Points)) :-
    format(Out, "<path id=\"chain-~d\" class=\"visible penetration\" \c
                 data-segment=\"~d\" data-other=\"~d\" d=\"",
           [C, S1, S2]),
    foldl(write_move(Out, Scale), Points, 'M', Next),
    (   Kind == point
    ->  foldl(write_move(Out, Scale), Points, Next, _)
    ;   true
    ),
    (   Kind == closed
    ->  format(Out, "Z\"/>~n", [])
    ;   format(Out, "\"/>~n", [])
    ).

write_move(Out, scale(F, Xm, Ym, Xc, Yc), X-Y, Command, 'L') :-
    Px is round((Xc + F*(X-Xm))*1000)/1000.0 + 0.0,
    Py is round((Yc - F*(Y-Ym))*1000)/1000.0 + 0.0,
    format(Out, "~w~3f ~3f", [Command, Px, Py]).
