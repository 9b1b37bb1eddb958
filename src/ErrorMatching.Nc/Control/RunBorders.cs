namespace ErrorMatching.Nc;

/// <summary>
/// A program that has another one's bytes over long stretches does there what that one does. At the border of each stretch a run notes its
/// state. Where a later run of a much like program arrives
/// at a border in the same state, to the last bit, and up to the next border has the same bytes, which only move, it takes those motions
/// over and goes on at that border. So the result is that of interpreting
/// every block, for a block does nothing else in the same state.
/// </summary>
internal sealed class RunBorders(ControlState control, ProgramRun run, RunResult result, BlockExecutor executor)
{
    /// <summary>Blocks from border to border; a power of two.</summary>
    public const int Stretch = 512;

    private readonly List<RunBorder> _borders = [];
    private int _next;

    // How many motions began elsewhere than the one before them ended, and how many problems there were, at the last border.
    private int _jumps;
    private int _problems;

    // The borders of a run of a much like program, and whether the stretch that ends at each is the same here.
    private IReadOnlyList<RunBorder> _known = [];
    private bool[] _isSame = [];

    public IReadOnlyList<RunBorder> Borders => _borders;

    /// <summary>Whether only plain cuts have run since the last border.</summary>
    public bool OnlyCuts { get; set; }

    /// <summary>True if there is a much like program to take motions over from.</summary>
    public bool AreKnown => _known.Count > 0;

    /// <summary>Takes the borders of a run of a much like program, and whether the stretch that ends at each is the same here.</summary>
    public void Expect(IReadOnlyList<RunBorder> known, bool[] isSame) => (_known, _isSame) = (known, isSame);

    /// <summary>
    /// Stretches of plain cuts that have the same bytes in another program, at the same lines, by the border at which each ends.
    /// </summary>
    public static bool[] SameStretches(NcProgram program, NcPath like)
    {
        var borders = Math.Min(like.Borders.Count, (program.BlockCount + Stretch - 1) / Stretch);
        var isSame = new bool[borders];
        if (borders < Halves.Many / Stretch)
        {
            Compare(1, borders);
        }
        else
        {
            Halves.Of(1, borders, Compare);
        }

        return isSame;

        bool Compare(int from, int behind)
        {
            for (var border = from; border < behind; border++)
            {
                isSame[border] = like.Borders[border].EndsCuts && Bytes(program, border).SequenceEqual(Bytes(like.Program, border));
            }

            return true;
        }
    }

    /// <summary>Begins at a border in the middle of the program.</summary>
    public void BeginAt(int border) => _next = border;

    /// <summary>Notes the state at a border. Only where it comes first: a loop runs over a border more than once.</summary>
    public void Note()
    {
        if (run.At == _next && run.At < run.Program.BlockCount)
        {
            var endsCuts = OnlyCuts && result.Motions.Jumps == _jumps && result.Problems.Count == _problems;
            _borders.Add(new(result.Motions.Length, control.State, executor.Integers.Count, endsCuts));
            (_next, OnlyCuts, _jumps, _problems) = (run.At + Stretch, true, result.Motions.Jumps, result.Problems.Count);
        }
    }

    /// <summary>Takes over the borders of what ran ahead, behind so many motions, but its first, which stands here already.</summary>
    public void Join(RunBorders ahead, int motions, NcMotions motionsAhead)
    {
        if (_next != run.At + Stretch)
        {
            return;
        }

        for (var i = 1; i < ahead._borders.Count; i++)
        {
            var border = ahead._borders[i];
            _borders.Add(border with { Motions = border.Motions - 1 + motions, Integers = border.Integers + executor.Integers.Count });
        }

        (_next, OnlyCuts, _jumps, _problems) =
            (ahead._next, ahead.OnlyCuts, result.Motions.Jumps - (motionsAhead.Jumps - ahead._jumps), result.Problems.Count);
    }

    /// <summary>Passes over stretches that are the same, if this run arrived as that one did. True if it did.</summary>
    public bool TryPass()
    {
        var (first, behind) = (run.At / Stretch, Math.Min(_known.Count, _isSame.Length));
        if (first + 1 >= behind || !_isSame[first + 1] || !StandsAs(_known[first].State)
            || !result.Motions.EndsAsAfter(_known[first].Motions))
        {
            return false;
        }

        // The first coordinate without a point is to be named, so its stretch is interpreted.
        var last = first;
        while (last + 1 < behind && _isSame[last + 1]
            && (executor.Integers.Count > 0 || _known[last + 1].Integers == _known[first].Integers))
        {
            last++;
        }

        result.Motions.TakeOver(_known[last].Motions);
        control.State = _known[last].State;
        executor.Integers.Add(_known[last].Integers - _known[first].Integers);
        run.At = last * Stretch;
        return last > first;
    }

    /// <summary>True if nothing waits for a motion, and all that a cut hangs on is as in another state, to the last bit.</summary>
    public bool StandsAs(in ModalState state) => executor.IsStraight() && control.State.SameAs(state);

    // The bytes between a border and the one before it.
    private static ReadOnlySpan<byte> Bytes(NcProgram program, int border) =>
        program.Bytes.Span[program[(border - 1) * Stretch].Start..program[border * Stretch].Start];
}
