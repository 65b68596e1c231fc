:- module(sg_shading_scan,
          [ scan/1,                     % +Options
            write_spans/1,              % +Out
            write_shading_facts/1       % +Out
          ]).
:- use_module('../kernel', [fill_spans/2, shading_scan/5]).
:- use_module('../store',
              [ facts_transaction/1, light/2, look/2, projection/1,
                retractall_facts/1, span/7, view/3
              ]).
:- use_module(group_owner, [owners_asked/2]).
:- use_module(shaded_picture, [world_scene/2]).
:- use_module(shading_scene, [scene_handle/2, scene_leaf/2]).
:- use_module(surface_look, [scene_opacities/2]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(option), [option/3]).
/** <module> What is seen of a world, as rows: span/7.

@see row CB-7
*/

%!  scan(+What) is det.
%
%   Fills span/7 with what is seen: of the solids among the roots of the current
%   world in its view, What being options as of shaded_picture/4, and smooth(N),
%   lines of a row (default 4); or of a scene (shading_scene.pl), What being
%   scene(Scene, N). Rows that were there go. What is see-through has its spans
%   one after the other, the nearest first. All of it is one step, to be undone
%   at once.
%
%   @error as of shaded_model/2 and shaded_eye/3

scan(What) :-
    must_be(nonvar, What),
    (   What = scene(Scene,Lines)
    ->  true
    ;   must_be(list, What),
        option(smooth(Lines), What, 4),
        (   world_scene(What, Scene0)
        ->  Scene = Scene0
        ;   Scene = none                % nothing is seen
        )
    ),
    facts_transaction(scene_scanned(Scene, Lines)).

scene_scanned(none, _) :-
    !,
    retractall_facts(span(_,_,_,_,_,_,_)).
scene_scanned(Scene, Lines) :-
    scene_handle(Scene, Handle),
    scene_opacities(Scene, opaque(Opacities,Leaves)),
    findall(S, scene_leaf(Scene, leaf(_,_,S,_,_)), Segments),
    owners_asked(Scene,
                 shading_scan(Handle, Lines, Opacities, Leaves, Scan)),
    fill_spans(Scan, Segments).

%!  write_spans(+Out) is det.
%
%   Writes span/7 to the stream Out, as CSV.

write_spans(Out) :-
    format(Out, 'y,k,x1,x2,root,leaf,face~n', []),
    forall(span(Y, K, X1, X2, R, S, F),
           format(Out, '~d,~d,~d,~d,~d,~d,~d~n', [Y,K,X1,X2,R,S,F])).

%!  write_shading_facts(+Out) is det.
%
%   Writes as facts to the stream Out how the world is looked at, its looks and
%   lights, and span/7.

write_shading_facts(Out) :-
    forall(( view(Theta, Phi, Rho), Fact = view(Theta,Phi,Rho)
           ; projection(Kind), Fact = projection(Kind)
           ; look(S, Property), Fact = look(S,Property)
           ; light(N, Property), Fact = light(N,Property)
           ; span(Y, K, X1, X2, R, S, F), Fact = span(Y,K,X1,X2,R,S,F)
           ),
           format(Out, '~q.~n', [Fact])).
