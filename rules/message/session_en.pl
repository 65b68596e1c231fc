:- module(sg_session_en,
          [ session_en//1               % +What
          ]).
:- use_module(message_parts, [meant_en//1]).
/** <module> What is wrong with a frame or a request of a session, in English;
session_ko.pl has the same heads in Korean.
*/

%!  session_en(+What)// is semidet.
%
%   What is wrong, and what to do.

session_en(frame(truncated)) -->
    [ 'the input ends in the middle of a frame' ].
session_en(frame(too_large(N))) -->
    [ 'a frame of ~D octets is too large'-[N], nl,
      '  A frame has 1,048,576 at most; name a file instead.' ].
session_en(frame(short(N))) -->
    [ 'a frame of ~D octets has no room for the length of its head'-[N] ].
session_en(frame(head_too_long(H))) -->
    [ 'the head of a frame is said to have ~D octets, more than the \c
       frame'-[H] ].
session_en(frame(not_utf8)) -->
    [ 'what a frame holds is not UTF-8: its head, or the text in its body' ].
session_en(frame(not_json)) -->
    [ 'the head of a frame is not JSON' ].
session_en(frame(not_an_object)) -->
    [ 'the head of a frame is JSON, but no object {...}' ].
session_en(frame(too_deep(Most))) -->
    [ 'the head of a frame has more than ~D objects and lists in one \c
       another'-[Most] ].
session_en(unknown_do(Do, Near, All)) -->
    { atomic_list_concat(All, ', ', Known) },
    [ 'a session does not do "~w"'-[Do] ],
    meant_en(Near),
    [ nl, '  It does: ~w.'-[Known] ].
session_en(bad_key(Key, Wanted)) -->
    { said_alone(Wanted) },
    [ '"~w": '-[Key] ],
    wanted_en(Wanted).
session_en(bad_key(Key, Wanted)) -->
    { \+ said_alone(Wanted) },
    [ 'the request needs a key "~w": '-[Key] ],
    wanted_en(Wanted).
session_en(verb_refused(Verb)) -->
    [ 'a session does not do the verb ~w'-[Verb], nl,
      '  Start it as a process of its own.' ].
session_en(no_folder(Folder)) -->
    [ '"cwd" is not the name of a folder that is there: ~p'-[Folder] ].
session_en(printed(Most)) -->
    [ 'the verb printed more than ~D octets'-[Most], nl,
      '  Let it write a file: -o FILE.' ].

session_en(no_end) -->
    [ 'the request came to no end and to no result: a fault of the program', nl,
      '  Please send the model and the request to those who made it.' ].
session_en(no_document) -->
    [ 'there is no document', nl,
      '  Open a model first: "do":"open".' ].
session_en(no_text) -->
    [ 'the document is not a file of facts, so it cannot be changed here', nl,
      '  Convert it: sanggwan convert MODEL -o MODEL.pl' ].
session_en(other_revision(At, Revision)) -->
    [ 'this was asked of revision ~p, but the document is at revision \c
       ~d'-[At, Revision], nl,
      '  Look at the document as it is now, and ask again.' ].
session_en(nothing_to(undo)) -->
    [ 'no change is left that could be undone' ].
session_en(nothing_to(redo)) -->
    [ 'no change is left that could be done again' ].
session_en(file_changed(File)) -->
    [ '~w is not as it was when it was opened'-[File], nl,
      '  Open it again and lose the changes, save under another name, or save \c
       with "force":true.' ].
session_en(no_journal(Path)) -->
    [ '~w is there, and is no journal: it is not written over'-[Path], nl,
      '  Give the journal another name.' ].
session_en(journal_of_another(Path)) -->
    [ 'the journal ~w has changes of another text than is in the file'-[Path],
      nl,
      '  Open with "replay":false to lose them, or without a journal.' ].
session_en(journal_damaged(Path, Done, Kept)) -->
    [ 'the journal ~w is damaged: ~D of its changes were done, the next one \c
       cannot be'-[Path, Done], nl,
      '  It is kept as it was: ~w.'-[Kept] ].
session_en(edit(no_fact(segment(S, _)))) -->
    [ 'the text has no fact segment(~p, ...)'-[S] ].
session_en(edit(no_fact(param(Name)))) -->
    [ 'the text has no fact param(~p, ...)'-[Name] ].
session_en(edit(no_path(Path))) -->
    [ 'the fact has nothing at the path ~p'-[Path], nl,
      '  A path has the number of an argument, then of one in it, and so \c
       on.' ].
session_en(edit(no_number(Path))) -->
    [ 'what the fact has at the path ~p is not a number'-[Path] ].
session_en(unsafe_goal(Goal)) -->
    [ 'a question may only read; this may do more: ~p'-[Goal] ].
session_en(thrown(Text)) -->
    [ 'the goal raised ~s'-[Text] ].
session_en(no_answers_left(Id)) -->
    [ 'no answers are left of the question ~p'-[Id] ].
session_en(too_long(seconds, Most)) -->
    [ 'the goal took more than ~w s'-[Most], nl,
      '  Ask for less at once.' ].
session_en(too_long(inferences, Most)) -->
    [ 'the goal took more than ~D inferences'-[Most], nl,
      '  Ask for less at once.' ].
session_en(edit(no_edge(Text))) -->
    [ '"~w" is no number and no name of an edge'-[Text], nl,
      '  An edge is named like 7, base-side(3) or v(3)-v(8).' ].
session_en(edit(no_wish(S, Edge))) -->
    [ 'the text does not say whether edge ~p of segment ~p is cut'-[Edge, S] ].
session_en(edit(no_question(Name))) -->
    [ 'the text has no question ~q'-[Name] ].
session_en(no_name(Name)) -->
    [ 'the picture has nothing called ~w'-[Name], nl,
      '  Names are those of its lines and parts, like s1e7; ask for them \c
       again after a change.' ].
session_en(owner_alone(rules)) -->
    [ 'rules run code, so only the owner may try or keep them', nl,
      '  The owner says "owner":true.' ].
session_en(owner_alone(save)) -->
    [ 'only the owner may save: what pupils change is kept for them alone' ].
session_en(owner_alone(class)) -->
    [ 'only the owner sees what all pupils answered' ].
session_en(owner_alone(show)) -->
    [ 'only the owner shows a picture to all' ].
session_en(no_class) -->
    [ 'there is no class with problems here', nl,
      '  Start one: sanggwan serve --problems FILE' ].
session_en(answers_inside(File)) -->
    [ '~w has answers of this class: the teacher alone opens it'-[File] ].
session_en(not_in_class) -->
    [ 'answers are of someone: say your name first' ].
session_en(owner_alone(journal)) -->
    [ 'the journal has rules, which run code, so only the owner may replay \c
       it', nl,
      '  The owner says "owner":true; "replay":false leaves its changes out.' ].
session_en(not_offered(Do)) -->
    [ 'a page does not ask for "~w"'-[Do] ].
session_en(outside(File)) -->
    [ '~w is no model in the folder of this studio'-[File], nl,
      '  Start it there: sanggwan serve MODEL' ].
session_en(too_many(Most)) -->
    [ 'more than ~D requests of this page wait'-[Most], nl,
      '  Ask again when some are answered.' ].
session_en(session_ended) -->
    [ 'the session ended before it answered', nl,
      '  What it had answered is kept; this was not done.' ].
session_en(open_to_others(Host, Port)) -->
    [ 'whoever reaches ~w:~w and knows the address below sees and changes \c
       this model; nothing is encrypted'-[Host, Port], nl,
      '  Rules, which run code, are not changed there. Without --host only \c
       this machine is let in.' ].
session_en(book_damaged(Path, Count, Kept)) -->
    [ '~D lines of the book of the class, ~w, are not as they were written: \c
       it goes on without them, and is kept as it was in ~w'-
      [Count, Path, Kept], nl,
      '  After a power failure a line may be half there, whose answers nobody \c
       was told of.' ].
session_en(behind(URL, Place)) -->
    [ 'whoever the proxy at ~w lets through and knows the address below sees \c
       and changes this model'-[URL], nl,
      '  It listens at ~w. Rules, which run code, are not changed \c
       there.'-[Place] ].
session_en(too_many_uploads(Most)) -->
    [ '~D files were sent already, as many as may be'-[Most], nl,
      '  Send one by the name of another, which it replaces.' ].
session_en(too_many_sessions(Most)) -->
    [ 'the studio has ~D sessions already, as many as it may'-[Most], nl,
      '  Try again when others have left.' ].
session_en(nothing_tried) -->
    [ 'no rules are tried', nl,
      '  Try some first: "do":"rules", with their text as the body.' ].

session_en(does(hello)) -->
    [ 'says who this is and what it does' ].
session_en(does(run)) -->
    [ 'does a verb of the command line, in an empty world' ].
session_en(does(stop)) -->
    [ 'ends what is under way, and all that waits' ].
session_en(does(help)) -->
    [ 'says what a session does, or what a word means' ].
session_en(does(complete)) -->
    [ 'says what the beginning of a word may become' ].
session_en(does(open)) -->
    [ 'opens a model as the document' ].
session_en(does(view)) -->
    [ 'draws the document' ].
session_en(does(ask)) -->
    [ 'finds the answers of a goal' ].
session_en(does(next)) -->
    [ 'gives more answers of a question' ].
session_en(does(explain)) -->
    [ 'says why something of the document is as it is' ].
session_en(does(export)) -->
    [ 'does a verb of the document' ].
session_en(does(select)) -->
    [ 'says what names of the document are, and keeps them' ].
session_en(does(sheet)) -->
    [ 'lays the document out on a sheet, as strokes' ].
session_en(does(shaded)) -->
    [ 'draws the document shaded, in PNG' ].
session_en(does(unfold)) -->
    [ 'lays the document flat, as strokes' ].
session_en(does(fold)) -->
    [ 'lays the document flat, as a FOLD file' ].
session_en(does(problems)) -->
    [ 'lists the problems of a file' ].
session_en(does(problem)) -->
    [ 'asks a problem, and says whether answers are right' ].
session_en(does(edit)) -->
    [ 'replaces a number of the model' ].
session_en(does(cut)) -->
    [ 'says whether an edge is cut or kept in patterns' ].
session_en(does(question)) -->
    [ 'keeps a question with the model, or takes one away' ].
session_en(does(text)) -->
    [ 'gives the text of the model, or another text to it' ].
session_en(does(tree)) -->
    [ 'gives the segments and parameters of the text, as forms show them' ].
session_en(does(undo)) -->
    [ 'takes the last change back' ].
session_en(does(redo)) -->
    [ 'does what was taken back again' ].
session_en(does(rules)) -->
    [ 'lists decisions; tries, keeps or discards rules' ].
session_en(does(reload)) -->
    [ 'takes the text that another program wrote into the file' ].
session_en(does(save)) -->
    [ 'writes the text of the model into its file' ].

said_alone(no_view(_, _, _)).
said_alone(no_segment(_, _)).

wanted_en(verb) -->
    [ 'a verb and its arguments, like ["draw", "tee.pl", "-o", "tee.svg"], \c
       without the character 0' ].
wanted_en(request) -->
    [ 'what is to be done, like "run"' ].
wanted_en(language) -->
    [ '"en" or "ko"' ].
wanted_en(positive) -->
    [ 'a number above 0' ].
wanted_en(least(Megabytes)) -->
    [ '~D or more, for the session has almost as much already'-[Megabytes] ].
wanted_en(goal) -->
    [ 'a goal, like "segment(S, Kind, Name)"' ].
wanted_en(ask) -->
    [ 'the id of a question with answers left' ].
wanted_en(file) -->
    [ 'the name of a model, like "tee.pl"' ].
wanted_en(journal) -->
    [ 'true, or the name of a file' ].
wanted_en(set) -->
    [ '{"segment":2, "path":[1,1], "value":0.8} or {"param":"d", \c
       "value":80}' ].
wanted_en(item) -->
    [ 'what is to be explained, like "line(1)"' ].
wanted_en(options) -->
    [ 'a list of options of the verb' ].
wanted_en(export) -->
    [ 'a verb and its options, without a model' ].
wanted_en(offered) -->
    [ 'a list of options that read and write no files' ].
wanted_en(download) -->
    [ 'what the file is to be called, like "tee.pdf"' ].
wanted_en(port) -->
    [ 'the name of a port' ].
wanted_en(format) -->
    [ '"strokes", "svg", "json", "pdf", "png" or "dxf"' ].
wanted_en(view) -->
    [ 'the name of a view, or [theta, phi] or [theta, phi, rho]' ].
wanted_en(section) -->
    [ 'a plane, like "x=5", "x" or "1,0,0,-5"' ].
wanted_en(factor) -->
    [ 'a number from 0 to 100' ].
wanted_en(one_cut) -->
    [ 'one of "section" and "explode", not both' ].
wanted_en(size) -->
    [ '[width, height] in millimetres' ].
wanted_en(segments) -->
    [ 'a list of numbers of segments' ].
wanted_en(no_view(Name, Near, All)) -->
    { atomic_list_concat(All, ', ', Known) },
    [ 'there is no view "~w"'-[Name] ],
    meant_en(Near),
    [ nl, '  There are ~w; or [theta, phi] in degrees.'-[Known] ].
wanted_en(no_segment(S, [])) -->
    [ 'there is no segment ~p: the picture has none'-[S] ].
wanted_en(no_segment(S, [First|More])) -->
    { atomic_list_concat([First|More], ', ', Known) },
    [ 'the picture has no segment ~p, but ~w'-[S, Known] ].
wanted_en(id) -->
    [ 'a whole number or a text, which the reply carries' ].
wanted_en(word) -->
    [ 'a word, like "line/9"' ].
wanted_en(text) -->
    [ 'the beginning of a word, of 200 characters at most' ].
wanted_en(question) -->
    [ 'what the question is called' ].
wanted_en(question_goal) -->
    [ 'the text of a goal, or null' ].
wanted_en(names) -->
    [ 'a list of names, like ["s1e7", "s2"], 1,000 at most' ].
wanted_en(edge) -->
    [ '"segment", a number; "edge", a number or a name like "base-side(3)"; \c
       and perhaps "keep": true, false or null' ].
wanted_en(segment) -->
    [ 'the number of a segment' ].
wanted_en(sheet(Sheets)) -->
    [ 'the number of a sheet, from 1 to ~d'-[Sheets] ].
wanted_en(upload) -->
    [ 'the name of a model (.pl, .csg, .stl, .off, .obj, .ply), without a \c
       folder' ].
wanted_en(pupil) -->
    [ 'a name, of 60 characters at most' ].
wanted_en(variant(Count)) -->
    [ 'the number of a variant, from 1 to ~d'-[Count] ].
wanted_en(answers(Count)) -->
    [ 'a list of texts, ~d of them'-[Count] ].
wanted_en(boolean) -->
    [ 'true or false' ].
wanted_en(one_of(Words)) -->
    { atomic_list_concat(Words, ', ', All) },
    [ 'one of ~w'-[All] ].
