:- module(sg_unfold_options,
          [ options_together/1          % +Options
          ]).
:- use_module(verb_output, [usage_error/1]).
:- use_module('../unfolding/unfold_how', [how_wished_of_any/2]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(option), [option/2]).
/** <module> Which options of the verb unfold go together.

An option that would say nothing is an error: who gave it wants something. What
it needs may also be said by the model (unfold_how.pl).
*/

%!  options_together(+Options:list) is det.
%
%   @error usage_error(unfold(needs(Option, Needed))): Option says nothing
%          without Needed, both as they are written
%   @error usage_error(both_options(Option1, Option2))

options_together(Options) :-
    (   needs(Name, Needed),
        given(Name, Options),
        \+ given(Needed, Options),
        \+ wished(Needed)
    ->  written(Name, Option),
        written(Needed, NeededOption),
        usage_error(unfold(needs(Option, NeededOption)))
    ;   given(faces, Options),
        given(true, Options)
    ->  usage_error(both_options('--faces', '--true'))
    ;   given(cells, Options),
        member(Other, [true,faces]),
        given(Other, Options)
    ->  written(Other, With),
        usage_error(both_options('--cells', With))
    ;   given(lines, Options),
        given(trim, Options)
    ->  usage_error(both_options('--lines', '--trim'))
    ;   given(gores, Options),
        given(zones, Options)
    ->  usage_error(both_options('--gores', '--zones'))
    ;   findall(Option,
                ( member(Name, [tabs,lap,'lock-seam']),
                  given(Name, Options),
                  written(Name, Option) ),
                [One,Other|_])
    ->  usage_error(both_options(One, Other))
    ;   scales(Options, [One,Other|_])
    ->  usage_error(both_options(One, Other))
    ;   true
    ).

%   scales(Options, Given): what of Options says the scale, or that there are no
%   pages to find it for.

scales(Options, Given) :-
    findall(Option,
            ( member(Name, [scale,height,pages,fit]),
              given(Name, Options),
              written(Name, Option)
            ),
            Scales),
    findall('--tile',
            ( given(tile, Options), Scales \== [],
              once(( member(Name, [pages,fit]), given(Name, Options) )) ),
            Tiles),
    append(Scales, Tiles, Given).

wished(true) :-
    !,
    how_wished_of_any(true_lengths, _),
    !.
wished(Name) :-
    how_wished_of_any(Name, _),
    !.

%   needs(?Name, ?Needed) is nondet.

needs(by, trim).
needs(Name, true) :-
    member(Name, [ seam,generators,half,gores,zones,chord,table,lengths,
                   'set-in','other-thickness' ]).
needs(Name, trim) :-
    member(Name, ['set-in','other-thickness']).
needs(Name, thickness) :-
    member(Name, [ size,kfactor,'bend-radius',relief,material,bends,'set-in',
                   'other-thickness' ]).
needs(overlap, tile).
needs(up, height).
needs('open-slits', tabs).
needs('tab-sides', tabs).

%   given(Name, Options): --no-NAME gives nothing.

given(Name, Options) :-
    Option =.. [Name,Value],
    option(Option, Options),
    Value \== false.

written(Name, Option) :-
    atom_concat('--', Name, Option).
