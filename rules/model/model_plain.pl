:- module(sg_model_plain,
          [ with_plain_facts/3,         % +Text, -Facts, :Goal
            plain_taken/3,              % +Facts, +Text, +Shift
            plain_added/2,              % +Facts, +Relation
            plain_segments/2            % +Facts, -Ss
          ]).
:- use_module('../kernel',
              [ plain_facts_open/2, plain_facts_close/1, plain_facts_take/4,
                plain_facts_add/2, plain_facts_segments/2
              ]).
/** <module> Plain facts of a model file, many at once.

Facts is facts(Handle), what of a text is plain, as of
c_kernels/model/plain_facts_rows.h,
or `none`: then all is read by model_text.pl, which also says what is wrong, and
where.
*/

:- meta_predicate with_plain_facts(+, -, 0).

%!  with_plain_facts(+Text, -Facts, :Goal) is semidet.
%
%   Call Goal once with the plain Facts of Text, none of which is taken yet. If
%   it fails Text is at its beginning again.

with_plain_facts(text(_, _, Stream), facts(Handle), Goal) :-
    stream_property(Stream, position(Start)),
    (   setup_call_cleanup(plain_facts_open(Stream, Handle),
                           once(Goal),
                           plain_facts_close(Handle))
    ->  true
    ;   set_stream_position(Stream, Start),
        fail
    ).

%!  plain_taken(+Facts, +Text, +Shift) is det.
%
%   What of Text is plain from where it is read now is among Facts, with the
%   numbers that Shift, as of shifted/3, makes of those of its segments.

plain_taken(none, _, _).
plain_taken(facts(Handle), text(_, _, Stream), shift(DS, _)) :-
    stream_property(Stream, position(From)),
    plain_facts_take(Handle, DS, From, To),
    (   To == From
    ->  true
    ;   set_stream_position(Stream, To)
    ).

%!  plain_added(+Facts, +Relation) is semidet.
%
%   The rows of a Relation that are among Facts are in the world. Fails if there
%   is anything wrong with one.

plain_added(none, _).
plain_added(facts(Handle), Relation) :-
    plain_facts_add(Handle, Relation).

%!  plain_segments(+Facts, -Ss:list) is det.
%
%   Ss are the segments of vertices, edges and polygons among Facts.

plain_segments(none, []).
plain_segments(facts(Handle), Ss) :-
    plain_facts_segments(Handle, Ss).
