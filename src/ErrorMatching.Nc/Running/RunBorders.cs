namespace ErrorMatching.Nc;

/// <summary>A program that shares long stretches of bytes with another does the same there. A run stores its state at the border of each
/// stretch. Suppose a later run of a similar program reaches a border in exactly the same state, and the bytes up to the next border are
/// equal and only move. Then it takes over those motions and continues at that border. The result equals interpreting every block,
/// because a block does the same in the same state.</summary>
internal sealed class RunBorders(NcControl control, BlockExecutor executor)
{
    /// <summary>Number of blocks from border to border; a power of two.</summary>
    public const int Stretch = 512;

    private readonly ProgramRun _run = control.Run;
    private readonly RunResult _result = control.Result;
    private readonly List<RunBorder> _borders = [];
    private int _next;

    // At the last border: the number of motions that did not begin at the end of the one before, and the number of problems.
    private int _jumps;
    private int _problems;

    // The borders of a run of a similar program, and whether the stretch that ends at each is equal here.
    private IReadOnlyList<RunBorder> _known = [];
    private bool[] _isSame = [];

    public IReadOnlyList<RunBorder> Borders => _borders;

    /// <summary>Whether only plain cuts have run since the last border.</summary>
    public bool OnlyCuts { get; set; }

    /// <summary>True if there is a similar program to take motions over from.</summary>
    public bool AreKnown => _known.Count > 0;

    /// <summary>Sets the borders of a run of a similar program, and whether the stretch that ends at each is equal here.</summary>
    public void Expect(IReadOnlyList<RunBorder> known, bool[] isSame) => (_known, _isSame) = (known, isSame);

    /// <summary>Stretches of plain cuts with the same bytes at the same lines in another program, by the border at which each
    /// ends.</summary>
    public static bool[] SameStretches(NcProgram program, NcPath like)
    {
        var borders = Math.Min(like.Borders.Count, (program.BlockCount + Stretch - 1) / Stretch);
        var isSame = new bool[borders];
        if (borders < TwoThreads.Many / Stretch)
        {
            Compare(1, borders);
        }
        else
        {
            TwoThreads.Run(1, borders, Compare);
        }

        return isSame;

        bool Compare(int from, int end)
        {
            for (var border = from; border < end; border++)
            {
                isSame[border] = like.Borders[border].EndsCuts && Bytes(program, border).SequenceEqual(Bytes(like.Program, border));
            }

            return true;
        }
    }

    /// <summary>Starts at a border in the middle of the program.</summary>
    public void BeginAt(int border) => _next = border;

    /// <summary>Stores the state at a border, the first time only: a loop passes a border more than once.</summary>
    public void Note()
    {
        if (_run.At == _next && _run.At < _run.Program.BlockCount)
        {
            var endsCuts = OnlyCuts && _result.Motions.Jumps == _jumps && _result.Problems.Count == _problems;
            _borders.Add(new(_result.Motions.Length, control.State, executor.Integers.Count, endsCuts));
            (_next, OnlyCuts, _jumps, _problems) = (_run.At + Stretch, true, _result.Motions.Jumps, _result.Problems.Count);
        }
    }

    /// <summary>Takes over the borders of a run ahead, after n motions, except its first, which is already here.</summary>
    public void Join(RunBorders ahead, int motions, NcMotions motionsAhead)
    {
        if (_next != _run.At + Stretch)
        {
            return;
        }

        for (var i = 1; i < ahead._borders.Count; i++)
        {
            var border = ahead._borders[i];
            _borders.Add(border with { Motions = border.Motions - 1 + motions, Integers = border.Integers + executor.Integers.Count });
        }

        (_next, OnlyCuts, _jumps, _problems) =
            (ahead._next, ahead.OnlyCuts, _result.Motions.Jumps - (motionsAhead.Jumps - ahead._jumps), _result.Problems.Count);
    }

    /// <summary>Skips equal stretches if this run arrived in the same state as the other. True if it did.</summary>
    public bool TryPass()
    {
        var (first, end) = (_run.At / Stretch, Math.Min(_known.Count, _isSame.Length));
        if (first + 1 >= end || !_isSame[first + 1] || !StandsAs(_known[first].State)
            || !_result.Motions.EndsAsAfter(_known[first].Motions))
        {
            return false;
        }

        // The first coordinate without a decimal point needs a note, so its stretch is interpreted.
        var last = first;
        while (last + 1 < end && _isSame[last + 1]
            && (executor.Integers.Count > 0 || _known[last + 1].Integers == _known[first].Integers))
        {
            last++;
        }

        _result.Motions.TakeOver(_known[last].Motions);
        control.State = _known[last].State;
        executor.Integers.Add(_known[last].Integers - _known[first].Integers);
        _run.At = last * Stretch;
        return last > first;
    }

    /// <summary>True if nothing is pending for a motion, and all that a cut depends on is bitwise as in another state.</summary>
    public bool StandsAs(in ModalState state) => executor.IsStraight() && control.State.SameAs(state);

    // The bytes between a border and the one before it.
    private static ReadOnlySpan<byte> Bytes(NcProgram program, int border) =>
        program.Bytes.Span[program[(border - 1) * Stretch].Start..program[border * Stretch].Start];
}
