namespace ErrorMatching.Nc;

/// <summary>Proves a rewriting: reads the result again, interprets it, and compares it with the original motion by motion and byte by
/// byte. It knows the wish but not the edits.</summary>
public sealed class Prover
{
    private readonly ProofTask _task;
    private readonly ProofFindings _findings;
    private readonly string? _marker;

    private Prover(ProofTask task, string? marker) => (_task, _findings, _marker) = (task, new(task.Before), marker);

    /// <summary>Compares a displaced program with its original.</summary>
    /// <param name="before">The original, interpreted.</param>
    /// <param name="result">The displaced program.</param>
    /// <param name="wish">The wished displacements; positions of motions are those of the original.</param>
    /// <param name="leastIncrementMm">Increment to which new coordinates were rounded.</param>
    /// <param name="marker">Text of the inserted comment line; null if there is none.</param>
    public static NcProof Check(NcPath before, NcProgram result, DisplacementWish wish, double leastIncrementMm, string? marker = null) =>
        new Prover(new(before, NcInterpreter.Run(result, before), wish, leastIncrementMm), marker).Run();

    private NcProof Run()
    {
        var markerBlock = new MarkerCheck(_task, _findings, _marker).Find();
        var moved = 0;
        var bytesIdentical = false;
        if (_task.After.Refusal is { } refusal)
        {
            _findings.Add(refusal);
        }
        else
        {
            CompensationCheck.Run(_task, _findings);
        }

        if (_findings.Failures.Count == 0 && DifferentMotions(markerBlock) is { } different)
        {
            // The two checks are independent, so for a long program they run concurrently.
            var parts = new ByteCheck(_task, different).Compare(markerBlock);
            moved = CompareMotions(different);
            CheckUncertainBlocks(markerBlock);
            bytesIdentical = true;
            foreach (var part in parts)
            {
                var (identical, failures) = part.GetAwaiter().GetResult();
                bytesIdentical &= identical;
                foreach (var failure in failures)
                {
                    _findings.Add(failure);
                }
            }
        }

        var failed = _findings.Failures;
        return new(
            failed.Count == 0,
            _task.Before.Motions.Length,
            moved,
            _findings.Neighbors,
            _marker,
            _findings.MaxDeviation,
            bytesIdentical,
            failed);
    }

    // The motions that differ in anything, in path order; null if they differ in more than their places.
    private List<int>? DifferentMotions(int markerBlock)
    {
        var (before, after) = (_task.Before.Motions, _task.After.Motions);
        if (before.Length != after.Length)
        {
            _findings.Fail($"The result has {after.Length} motions, the original {before.Length}.");
            return null;
        }

        var different = before.DifferencesFrom(after, markerBlock);
        foreach (var i in different)
        {
            var (was, now) = (before[i], after[i]);
            const MotionFlags Spelling = MotionFlags.ByRadius;
            if (now.Block != InResult(was.Block, markerBlock) || now.Kind != was.Kind || now.Plane != was.Plane
                || now.IsVertical != was.IsVertical
                || (now.Flags & ~Spelling) != (was.Flags & ~Spelling) || now.Turns != was.Turns
                || now.Frame != was.Frame || now.Feed != was.Feed
                || now.UnknownStart != was.UnknownStart || now.UnknownEnd != was.UnknownEnd)
            {
                _findings.Fail(was.Block, "its kind, plane, modes, feed or turns differ from the original.");
            }
        }

        return _findings.Failures.Count == 0 ? different : null;
    }

    private static int InResult(int block, int markerBlock) => block >= markerBlock ? block + 1 : block;

    private int CompareMotions(List<int> different)
    {
        var ways = new WayCheck(_task, _findings);
        var arcs = new ArcCheck(_task, _findings);
        var fillets = new FilletCheck(_task, _findings);
        var joints = new JointCheck(_task, _findings, ways, new(_task, ways), fillets);
        var elements = new ElementCheck(_task, _findings, arcs, fillets, joints);
        var endPoints = new EndPointCheck(_task, _findings, ways, arcs);
        var neighbors = new NeighborCheck(_task, _findings, ways, arcs, fillets);
        var allowed = joints.Allowed();
        var moved = 0;
        foreach (var i in ToCompare(different))
        {
            var (was, now) = (_task.Before.Motions[i], _task.After.Motions[i]);
            var (startMoved, endMoved) = (!ProofTask.Same(was.Start, now.Start), !ProofTask.Same(was.End, now.End));
            var differs = startMoved || endMoved || (was.IsArc && !ProofTask.Same(was.Center, now.Center));
            moved += differs ? 1 : 0;
            if ((startMoved && (!allowed[i] || ways.IsOtherTools(i, i))) || (endMoved && (!allowed[i + 1] || ways.IsOtherTools(i, i + 1))))
            {
                _findings.Fail(was.Block, "it moved although neither it nor a motion beside it was named.");
            }
            else if (_task.Elements.IndexOf(i) is >= 0 and var element)
            {
                elements.Check(_task.Wish.Elements[element], was, now);
            }
            else if (_task.Wish.EndPoints.Count > 0)
            {
                endPoints.Check(i, was, now, startMoved, endMoved);
            }
            else if (differs)
            {
                neighbors.Check(i, was, now, startMoved, endMoved);
            }
        }

        CheckPlaceDependents();
        return moved;
    }

    // An origin that is set, or a program that is called, at the tool's current place must find the tool where it was.
    private void CheckPlaceDependents()
    {
        foreach (var (block, joint) in _task.Before.PlaceDependents)
        {
            // The next motion may use a new origin, so the end before it is compared.
            var motion = joint - 1;
            if (motion >= 0 && !ProofTask.Same(_task.Before.Motions[motion].End, _task.After.Motions[motion].End))
            {
                _findings.Fail(block, "an origin is set or a program is called here at a place that moved.");
            }
        }
    }

    // What is executed only if a value of the machine says so must be as it was.
    private void CheckUncertainBlocks(int markerBlock)
    {
        var (before, after) = (_task.Before, _task.After);
        if (!before.UncertainBlocks.Select(b => InResult(b, markerBlock)).SequenceEqual(after.UncertainBlocks))
        {
            _findings.Fail("Other blocks than in the original depend on values of the machine.");
            return;
        }

        foreach (var block in before.UncertainBlocks)
        {
            var now = after.Program.BytesOf(after.Program[InResult(block, markerBlock)]);
            if (!before.Program.BytesOf(before.Program[block]).SequenceEqual(now))
            {
                _findings.Fail(block, "it changed although whether it is cut depends on a value of the machine.");
            }
        }
    }

    // An equal motion did not move, so only the different and the named motions are compared.
    private IEnumerable<int> ToCompare(List<int> different)
    {
        var next = 0;
        foreach (var motion in _task.Wish.Elements.Count > 0 ? _task.Wish.Elements.Select(e => e.Motion) : _task.Wish.EndPoints)
        {
            for (; next < different.Count && different[next] < motion; next++)
            {
                yield return different[next];
            }

            next += next < different.Count && different[next] == motion ? 1 : 0;
            yield return motion;
        }

        for (; next < different.Count; next++)
        {
            yield return different[next];
        }
    }
}
