namespace ErrorMatching.Nc;

/// <content>
/// A program that has another one's bytes over long stretches does there what that one does. At the border of each stretch a run notes its state. Where a later run of a much like program arrives
/// at a border in the same state, to the last bit, and up to the next border has the same bytes, which only move, it takes those motions over and goes on at that border. So the result is that of interpreting
/// every block, for a block does nothing else in the same state.
/// </content>
public sealed partial class NcInterpreter
{
    /// <summary>Blocks from border to border; a power of two.</summary>
    private const int Stretch = 512;

    private readonly List<RunBorder> _borders = [];
    private int _nextBorder;

    // Whether only plain cuts have run since the last border, and how many motions began elsewhere than the one before them ended.
    private bool _onlyCuts;
    private int _jumps;

    // The borders of a run of a much like program, and whether the stretch that ends at each is the same here.
    private IReadOnlyList<RunBorder> _known = [];
    private bool[] _isSame = [];

    /// <summary>Interprets a program as another was that it is much like: motions that are the same take no memory of their own, and those in stretches with the same bytes little time.</summary>
    internal static NcPath Run(NcProgram program, NcPath like)
    {
        program = program.In(like.Dialect.Syntax);
        var isSame = SameStretches(program, like);

        // Where less than half of a long program is the same, two cores are faster.
        var passes = program.BlockCount < Many || isSame.Count(s => s) > isSame.Length / 2;
        return new NcInterpreter(program, like.Dialect, new(like.Motions, inPlace: passes), like.Library, CancellationToken.None)
        {
            _known = passes ? like.Borders : [],
            _isSame = isSame,
        }.Run();
    }

    // Stretches of plain cuts that have the same bytes in another program, at the same lines.
    private static bool[] SameStretches(NcProgram program, NcPath like)
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

    // The bytes between a border and the one before it.
    private static ReadOnlySpan<byte> Bytes(NcProgram program, int border) => program.Bytes.Span[program[(border - 1) * Stretch].Start..program[border * Stretch].Start];

    // Comes to a border in the program itself. True if the run goes on elsewhere.
    private bool CrossBorder(CancellationToken endOfAhead)
    {
        if (_known.Count > 0)
        {
            return TryPass();
        }

        NoteBorder();
        if (_at == LeadIn && _program.BlockCount >= Many)
        {
            StartAhead(endOfAhead);
        }

        return _at == _seam && TryJoinAhead();
    }

    // Only where it comes first: a loop runs over a border more than once.
    private void NoteBorder()
    {
        if (_at == _nextBorder && _at < _program.BlockCount)
        {
            _borders.Add(new(_motions.Length, _state, _integers, _onlyCuts && _motions.Jumps == _jumps));
            (_nextBorder, _onlyCuts, _jumps) = (_at + Stretch, true, _motions.Jumps);
        }
    }

    // Takes over the borders of what ran ahead, behind so many motions, but its first, which stands here already.
    private void JoinBorders(NcInterpreter ahead, int motions)
    {
        if (_nextBorder != _at + Stretch)
        {
            return;
        }

        for (var i = 1; i < ahead._borders.Count; i++)
        {
            var border = ahead._borders[i];
            _borders.Add(border with { Motions = border.Motions - 1 + motions, Integers = border.Integers + _integers });
        }

        (_nextBorder, _onlyCuts, _jumps) = (ahead._nextBorder, ahead._onlyCuts, _motions.Jumps - (ahead._motions.Jumps - ahead._jumps));
    }

    // Passes over stretches that are the same, if this run arrived as that one did.
    private bool TryPass()
    {
        var (first, behind) = (_at / Stretch, Math.Min(_known.Count, _isSame.Length));
        if (first + 1 >= behind || !_isSame[first + 1] || !IsStraight() || !_state.SameAs(_known[first].State) || !_motions.EndsAsAfter(_known[first].Motions))
        {
            return false;
        }

        // The first coordinate without a point is to be named, so its stretch is interpreted.
        var last = first;
        while (last + 1 < behind && _isSame[last + 1] && (_integers > 0 || _known[last + 1].Integers == _known[first].Integers))
        {
            last++;
        }

        _motions.TakeOver(_known[last].Motions);
        (_state, _integers, _at) = (_known[last].State, _integers + _known[last].Integers - _known[first].Integers, last * Stretch);
        return last > first;
    }
}
