namespace ErrorMatching.Nc;

/// <content>
/// The second core begins in the middle of a long program, with the modes that its first blocks set and the place that the blocks before the middle lead to. That is a guess: when the
/// first core arrives there and its state is another one, to the last bit, what ran ahead counts for nothing. So the result is that of one core.
/// </content>
public sealed partial class NcInterpreter
{
    /// <summary>From so many blocks on, a second core is worth its start.</summary>
    private const int Many = 100_000;

    /// <summary>So many first blocks set the modes, and so many blocks lead to the middle.</summary>
    private const int LeadIn = 16 * Stretch;

    /// <summary>What runs ahead is looked at for an end that often, in blocks.</summary>
    private const int Watch = 1_024;

    private const uint CutLetters = CenterWords | (1u << ('R' - 'A'));

    private int _seam = int.MaxValue;
    private Task<NcInterpreter?>? _ahead;

    // The state in which this one began, if it runs ahead.
    private ModalState _began;

    private void StartAhead(CancellationToken end)
    {
        if (_ahead is null && IsStraight())
        {
            var (state, seam) = (_state, _program.BlockCount / 2 / Stretch * Stretch);
            _seam = seam;
            _ahead = Task.Run(() => Ahead(state, seam, end), CancellationToken.None);
        }
    }

    // The rest of the program from the seam on, as far as it has cuts and rapids only; null where something else leads to the seam.
    private NcInterpreter? Ahead(ModalState state, int seam, CancellationToken end)
    {
        var before = new NcInterpreter(_program, _dialect, new(), null, end) { _state = state, _at = seam - LeadIn };
        before.RunCuts(seam);
        if (before._at < seam || before._motions.Length == 0)
        {
            return null;
        }

        var ahead = new NcInterpreter(_program, _dialect, _motions.Ahead(before._motions), null, end) { _state = before._state, _at = seam, _nextBorder = seam, _began = before._state };
        ahead.RunCuts(_program.BlockCount);

        // A problem would have to be told in its order, and only once; there should be none.
        return ahead._problems.Count == 0 ? ahead : null;
    }

    // Runs blocks up to one that could do more than move, which is not run.
    private void RunCuts(int behind)
    {
        for (; _at < behind; _at++)
        {
            _block = _at;
            if ((_at & (Stretch - 1)) == 0)
            {
                NoteBorder();
            }

            if (((_at & (Watch - 1)) == 0 && _cancellation.IsCancellationRequested) || !_words.TryReadPlain(_program.BytesOf(_program[_at]), _dialect.Syntax))
            {
                return;
            }

            if (TryRunStraight())
            {
                continue;
            }

            if (!IsCut())
            {
                return;
            }

            Step();
        }
    }

    private bool IsCut()
    {
        var isCut = (_words.Present & ~_cutLetters) == 0 && _words.Repeated == 0 && _words.Functions.Length == 0 && IsStraight();
        foreach (var code in _words.Codes)
        {
            isCut &= _dialect.MeaningOf(code) is NcMeaning.Rapid or NcMeaning.Line or NcMeaning.ArcClockwise or NcMeaning.ArcCounterClockwise;
        }

        return isCut;
    }

    // Goes on where the second core has come to, if it began as the program really arrives at the seam.
    private bool TryJoinAhead()
    {
        _seam = int.MaxValue;
        if (!IsStraight() || _ahead is not { Status: >= TaskStatus.Running })
        {
            return false;
        }

        if (_ahead.GetAwaiter().GetResult() is not { } ahead || !_state.SameAs(ahead._began) || !_motions.EndsWhereBegins(ahead._motions))
        {
            return false;
        }

        var before = _motions.Length;
        _motions.Join(ahead._motions);
        JoinBorders(ahead, before);
        (_state, _at) = (ahead._state, ahead._at);
        (_firstInteger, _integers) = (_integers > 0 ? _firstInteger : ahead._firstInteger, _integers + ahead._integers);
        return true;
    }
}
