namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// A second, deliberately small NC interpreter. It was written from the meaning of the words (ISO 6983-1) and shares no code with the
/// library, so that an error of the library's own interpreter cannot hide itself. What it does not know and could move an axis, it refuses.
/// The tool starts at the origin.
/// </summary>
internal sealed class RefereeInterpreter
{
    private readonly List<RefereeMove> _moves = [];
    private Spot _at;
    private double _unit = 1;
    private bool _incremental;
    private int _motion;
    private WorkPlane _plane = WorkPlane.XY;
    private CutterSide _side = CutterSide.None;

    private RefereeInterpreter()
    {
    }

    /// <summary>All moves of a program, rapid ones and those at rest included, in order.</summary>
    public static IReadOnlyList<RefereeMove> Run(string program)
    {
        var interpreter = new RefereeInterpreter();
        var lines = program.Split('\n');
        for (var i = 0; i < lines.Length; i++)
        {
            var block = RefereeBlock.Read(lines[i].TrimEnd('\r'), i + 1);
            interpreter.Execute(block);
            if (block.Miscellaneous.Any(m => m is 2 or 30))
            {
                break;
            }
        }

        return interpreter._moves;
    }

    private void Execute(RefereeBlock block)
    {
        foreach (var letter in block.Letters.Where(l => !"GMOFSTHDXYZIJKRP".Contains(l)))
        {
            throw new RefereeException($"line {block.Line}: the word {letter} could move an axis");
        }

        if (block.Miscellaneous.Any(m => m is 97 or 98 or 99))
        {
            throw new RefereeException($"line {block.Line}: subprograms are not known here");
        }

        var dwell = false;
        var home = false;
        foreach (var g in block.Preparatory)
        {
            dwell |= g == 4;
            home |= g is 28 or 30;
            Select(g, block.Line);
        }

        if (home)
        {
            ForgetNamedAxes(block);
        }
        else if (!dwell && (block.Has('X') || block.Has('Y') || block.Has('Z') || HasCenter(block)))
        {
            Move(block);
        }
    }

    private void Select(double g, int line)
    {
        switch (g)
        {
            case 0 or 1 or 2 or 3:
                _motion = (int)g;
                break;
            case 17:
                _plane = WorkPlane.XY;
                break;
            case 18:
                _plane = WorkPlane.ZX;
                break;
            case 19:
                _plane = WorkPlane.YZ;
                break;
            case 20:
                _unit = 25.4;
                break;
            case 21:
                _unit = 1;
                break;
            case 40:
                _side = CutterSide.None;
                break;
            case 41:
                _side = CutterSide.Left;
                break;
            case 42:
                _side = CutterSide.Right;
                break;
            case 90:
                _incremental = false;
                break;
            case 91:
                _incremental = true;
                break;
            case 4 or 28 or 30 or 43 or 49 or 80 or 94 or (>= 54 and <= 59) or 61 or 64:
                break;
            default:
                throw new RefereeException($"line {line}: G{g:R} is not known here");
        }
    }

    private void ForgetNamedAxes(RefereeBlock block) =>
        _at = new(block.Has('X') ? double.NaN : _at.X, block.Has('Y') ? double.NaN : _at.Y, block.Has('Z') ? double.NaN : _at.Z);

    private void Move(RefereeBlock block)
    {
        var to = new Spot(Target(block.Value('X'), _at.X), Target(block.Value('Y'), _at.Y), Target(block.Value('Z'), _at.Z));
        var move = new RefereeMove(block.Number, block.Line, _motion == 0, _at, to, _plane, _side);
        if (_motion >= 2)
        {
            move = move.Around(block.Has('R') ? CenterByRadius(block, move) : CenterByOffset(block), _motion == 3);
        }
        else if (HasCenter(block))
        {
            throw new RefereeException($"line {block.Line}: I, J, K or R without an arc");
        }

        // A move along one axis leaves an unknown other one unknown; a feed move in the plane must know where it is.
        if (!move.Rapid && double.IsNaN((to.In(_plane) - _at.In(_plane)).Length))
        {
            throw new RefereeException($"line {block.Line}: a feed move from or to an unknown place");
        }

        _moves.Add(move);
        _at = to;
    }

    private double Target(double? word, double now) => word is not { } value ? now : _incremental ? now + (value * _unit) : value * _unit;

    private static bool HasCenter(RefereeBlock block) => block.Has('I') || block.Has('J') || block.Has('K') || block.Has('R');

    private Flat CenterByOffset(RefereeBlock block)
    {
        if (!HasCenter(block) || block.Has('P'))
        {
            throw new RefereeException($"line {block.Line}: an arc needs I, J, K or R and no turns");
        }

        var offset = new Spot(block.Value('I') ?? 0, block.Value('J') ?? 0, block.Value('K') ?? 0);
        return _at.In(_plane) + (offset.In(_plane) * _unit);
    }

    /// <summary>A positive R is the arc of at most half a turn, a negative one the longer.</summary>
    private Flat CenterByRadius(RefereeBlock block, RefereeMove move)
    {
        var radius = block.Value('R')!.Value * _unit;
        var from = move.From.In(_plane);
        var chord = move.To.In(_plane) - from;
        var half = chord.Length / 2;
        if (block.Has('I') || block.Has('J') || block.Has('K') || half < 1e-9 || half > Math.Abs(radius) + 0.0015)
        {
            throw new RefereeException($"line {block.Line}: R {radius:R} spans no chord of {chord.Length:R}");
        }

        var height = Math.Sqrt(Math.Max(0, (radius * radius) - (half * half)));
        var onLeft = (_motion == 3) == (radius > 0);
        return from + (chord * 0.5) + (chord.Unit().Left * (onLeft ? height : -height));
    }
}
