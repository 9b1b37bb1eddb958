using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>
/// Proves what a rewriting did: reads the result again, interprets it, and compares it with the original motion by motion and byte by byte. It knows the wish,
/// never the edits.
/// </summary>
public sealed partial class Prover
{
    /// <summary>How far a vertex may go, in multiples of the largest displacement asked for: a corner of 10 degrees needs 11.5.</summary>
    private const double FurthestCorner = 13;

    /// <summary>From so many changed motions on, a second core is worth its start.</summary>
    private const int Many = 10_000;

    /// <summary>Places closer than this are one, mm.</summary>
    private const double SamePlace = 1e-9;

    private readonly NcPath _before;
    private readonly NcPath _after;
    private readonly DisplacementWish _wish;
    private readonly string? _marker;
    private readonly double _increment;
    private readonly MotionRuns _elements = new();
    private readonly MotionRuns _endPoints = new();
    private readonly Dictionary<int, int> _closures = [];
    private List<int> _different = [];
    private readonly List<NcRefusal> _failures = [];
    private readonly List<ProofNeighbor> _neighbors = [];
    private readonly Dictionary<(int Block, NeighborRole Role), int> _noted = [];
    private readonly double _reach;
    private double _maxDeviation;

    private Prover(NcPath before, NcPath after, DisplacementWish wish, string? marker, double increment)
    {
        _before = before;
        _after = after;
        _wish = wish;
        _marker = marker;
        _increment = increment;
        var largest = 0.0;
        foreach (var element in wish.Elements)
        {
            _elements.Add(element.Motion);
            largest = Math.Max(largest, Math.Max(element.Start.Length, element.End.Length));
        }

        foreach (var motion in wish.EndPoints)
        {
            _endPoints.Add(motion);
        }

        _reach = (FurthestCorner * largest) + (2 * increment);
    }

    /// <summary>Compares a displaced program with its original.</summary>
    /// <param name="before">The original, interpreted.</param>
    /// <param name="result">The displaced program.</param>
    /// <param name="wish">What was to be displaced; positions of motions are those of the original.</param>
    /// <param name="leastIncrementMm">Increment to which new coordinates were rounded.</param>
    /// <param name="marker">Text of the one comment line that was inserted, or null.</param>
    public static NcProof Check(NcPath before, NcProgram result, DisplacementWish wish, double leastIncrementMm, string? marker = null) =>
        new Prover(before, NcInterpreter.Run(result, before), wish, marker, leastIncrementMm).Run();

    private NcProof Run()
    {
        var markerBlock = FindMarker();
        var moved = 0;
        var bytesIdentical = false;
        if (_after.Refusal is { } refusal)
        {
            _failures.Add(refusal);
        }

        if (_failures.Count == 0 && SameStructure(markerBlock))
        {
            // The two look at different things and need nothing of each other, so a long program has them beside each other.
            var parts = CompareBytes(markerBlock);
            moved = CompareMotions();
            bytesIdentical = true;
            foreach (var part in parts)
            {
                var (identical, failures) = part.GetAwaiter().GetResult();
                bytesIdentical &= identical;
                _failures.AddRange(failures);
            }
        }

        return new(_failures.Count == 0, _before.Motions.Length, moved, _neighbors, _marker, _maxDeviation, bytesIdentical, _failures);
    }

    private void Fail(int block, string what) => _failures.Add(Failure(block, what));

    private NcRefusal Failure(int block, string what) => NcRefusal.At(_before.Program, block, NcRefusalCodes.ProofFailed, what);

    // The line that holds the marker in the result, or -1 where none was asked for.
    private int FindMarker()
    {
        var extra = _after.Program.BlockCount - _before.Program.BlockCount;
        if (extra != (_marker is null ? 0 : 1))
        {
            _failures.Add(new(NcRefusalCodes.ProofFailed, "", 0, $"The result has {_after.Program.BlockCount} lines, expected {_before.Program.BlockCount + (_marker is null ? 0 : 1)}."));
            return -1;
        }

        if (_marker is null)
        {
            return -1;
        }

        var line = LineOf(_after.Program, Encoding.UTF8.GetBytes(_marker));
        if (line >= 0)
        {
            CheckMarker(line);
            return line;
        }

        _failures.Add(new(NcRefusalCodes.ProofFailed, "", 0, "The marker comment is not in the result."));
        return -1;
    }

    // The first line that is a text and nothing else, or -1.
    private static int LineOf(NcProgram program, ReadOnlySpan<byte> text)
    {
        var bytes = program.Bytes.Span;
        for (var from = 0; bytes[from..].IndexOf(text) is >= 0 and var offset; from += offset + 1)
        {
            var line = program.BlockAt(from + offset);
            if (program.BytesOf(program[line]).SequenceEqual(text))
            {
                return line;
            }
        }

        return -1;
    }

    // The marker does nothing and ends as the lines beside it end.
    private void CheckMarker(int line)
    {
        var program = _after.Program;
        var onlyComment = true;
        foreach (var token in program.Tokens(program[line]))
        {
            onlyComment &= token.Kind is NcTokenKind.Comment or NcTokenKind.Space;
        }

        var beside = line > 0 ? line - 1 : line + 1;
        if (!onlyComment || (beside < program.BlockCount && !LineEnd(program, line).SequenceEqual(LineEnd(program, beside))))
        {
            _failures.Add(new(NcRefusalCodes.ProofFailed, "", 0, "The marker is not a plain comment line."));
        }
    }

    private static ReadOnlySpan<byte> LineEnd(NcProgram program, int line) =>
        program.Bytes.Span[program[line].End..(program[line].Start + program[line].FullLength)];

    private bool SameStructure(int markerBlock)
    {
        if (_before.Motions.Length != _after.Motions.Length)
        {
            _failures.Add(new(NcRefusalCodes.ProofFailed, "", 0, $"The result has {_after.Motions.Length} motions, the original {_before.Motions.Length}."));
            return false;
        }

        var border = _marker is null ? int.MaxValue : markerBlock;
        _different = _before.Motions.DifferencesFrom(_after.Motions, border);
        foreach (var i in _different)
        {
            var (was, now) = (_before.Motions[i], _after.Motions[i]);
            const MotionFlags Spelling = MotionFlags.ByRadius;
            if (now.Block != InResult(was.Block, markerBlock) || now.Kind != was.Kind || now.Plane != was.Plane || (now.Flags & ~Spelling) != (was.Flags & ~Spelling)
                || now.Turns != was.Turns || now.Frame != was.Frame || now.Feed != was.Feed || now.UnknownStart != was.UnknownStart || now.UnknownEnd != was.UnknownEnd)
            {
                Fail(was.Block, "its kind, plane, modes, feed or turns differ from the original.");
            }
        }

        return _failures.Count == 0;
    }

    private static int InResult(int block, int markerBlock) => markerBlock >= 0 && block >= markerBlock ? block + 1 : block;

    private int CompareMotions()
    {
        FindClosures();
        var allowed = AllowedJoints();
        var moved = 0;
        foreach (var i in ToCompare())
        {
            var (was, now) = (_before.Motions[i], _after.Motions[i]);
            var (startMoved, endMoved) = (!Same(was.Start, now.Start), !Same(was.End, now.End));
            var differs = startMoved || endMoved || (was.IsArc && !Same(was.Center, now.Center));
            moved += differs ? 1 : 0;
            if ((startMoved && (!allowed[i] || IsOtherTools(i, i))) || (endMoved && (!allowed[i + 1] || IsOtherTools(i, i + 1))))
            {
                Fail(was.Block, "it moved although neither it nor a motion beside it was named.");
            }
            else if (_elements.IndexOf(i) is >= 0 and var element)
            {
                CheckElement(_wish.Elements[element], was, now);
            }
            else if (_wish.EndPoints.Count > 0)
            {
                CheckEndPoint(i, was, now, startMoved, endMoved);
            }
            else if (differs)
            {
                CheckNeighbor(i, was, now, startMoved, endMoved);
            }
        }

        CheckPlaceDependents();
        return moved;
    }

    // A motion that is the same in both has moved nowhere, so only the named ones are looked at besides those that differ.
    private IEnumerable<int> ToCompare()
    {
        var next = 0;
        foreach (var motion in _wish.Elements.Count > 0 ? _wish.Elements.Select(e => e.Motion) : _wish.EndPoints)
        {
            for (; next < _different.Count && _different[next] < motion; next++)
            {
                yield return _different[next];
            }

            next += next < _different.Count && _different[next] == motion ? 1 : 0;
            yield return motion;
        }

        for (; next < _different.Count; next++)
        {
            yield return _different[next];
        }
    }

    private static bool Same(Point3 a, Point3 b) => (a - b).Length < SamePlace;

    private static bool Same(Point2 a, Point2 b) => a.DistanceTo(b) < SamePlace;
}
