:- module(sg_picture_cut,
          [ segments_cut/1,             % +Options
            sewn_cut/1,                 % +Options
            pieces_cut/1,               % +Options
            penetrated/1                % +Options
          ]).
:- use_module(sew, [borders_sewn/1]).
:- use_module('../penetration/penetration', [penetrate/2]).
:- use_module('../store', [segment/3, line/9, origin/3]).
/** <module> What is cut before a picture is made.
*/

%!  segments_cut(+Options:list) is det.
%!  sewn_cut(+Options:list) is det.
%
%   Patches are sewn (sew.pl), if they were not before, and the segments of the
%   current world cut each other, if there are several, and themselves. Options
%   as of penetrate/2.

segments_cut(Options) :-
    borders_sewn(_),
    sewn_cut(Options).

sewn_cut(Options) :-
    (   several_segments
    ->  penetrated([themselves(true),shown(true)|Options])
    ;   pieces_cut(Options)
    ).

several_segments :-
    segment(A, _, _),
    segment(B, _, _),
    A \== B,
    !.

%!  pieces_cut(+Options:list) is det.
%
%   The same of the pieces of a section, which needs no notice.

pieces_cut(Options) :-
    penetrate(all, [themselves(true),shown(true)|Options]).

%!  penetrated(+Options:list) is det.
%
%   The segments cut each other, or a notice says why not.

penetrated(Options) :-
    penetrate(all, Options),
    (   \+ several_segments
    ->  print_message(informational, sanggwan(one_segment))
    ;   line(_, _, _, _, _, _, _, _, _)
    ->  true
    ;   origin(_, v(_), _)
    ->  true
    ;   print_message(informational, sanggwan(do_not_meet))
    ).
