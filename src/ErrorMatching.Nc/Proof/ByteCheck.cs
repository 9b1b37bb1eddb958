using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Checks that every byte is the original's, except in the values of words that had to change.</summary>
internal sealed class ByteCheck(ProofTask task, List<int> different)
{
    /// <summary>Minimum number of changed motions for a second thread to pay off.</summary>
    private const int Many = 10_000;

    /// <summary>Number of blocks in a chunk if many differ; idle threads take the next chunk.</summary>
    private const int PartOfMany = 16_384;

    private readonly Lazy<HashSet<int>> _movedPoles = new(() => MovedPoles(task));

    public List<Task<(bool Identical, List<Refusal> Failures)>> Compare(int markerBlock)
    {
        var blocks = task.Before.Program.BlockCount;
        var border = Math.Min(markerBlock, blocks);
        return [.. Compare(0, border, 0), .. Compare(border, blocks, 1)];
    }

    private IEnumerable<Task<(bool Identical, List<Refusal> Failures)>> Compare(int from, int end, int linesBefore)
    {
        var many = different.Count >= Many;
        for (var first = from; first < end;)
        {
            var (begin, partEnd) = (first, many ? Math.Min(end, first + PartOfMany) : end);
            yield return many
                ? Task.Run(() => ComparePart(begin, partEnd, linesBefore))
                : Task.FromResult(ComparePart(begin, partEnd, linesBefore));
            first = partEnd;
        }
    }

    // Compares blocks that are a number of lines further down in the result.
    private (bool Identical, List<Refusal> Failures) ComparePart(int first, int end, int linesBefore)
    {
        var compared = new BlockComparison(task.Before, task.After);
        var failures = new List<Refusal>();
        var (identical, recent) = (true, 0);
        for (var i = compared.NextDifference(first, end, linesBefore);
            i < end;
            i = compared.NextDifference(i + 1, end, linesBefore))
        {
            var motion = task.Before.RunOf(i, 0, ref recent);
            if (motion < 0 && _movedPoles.Value.Contains(i))
            {
                if (!compared.SameButPlace(i, i + linesBefore))
                {
                    failures.Add(ProofFindings.Failure(task.Before, i, "something other than the place of a center changed in it."));
                    identical = false;
                }
            }
            else if (motion < 0 || !compared.SameButCoordinates(motion, i, i + linesBefore))
            {
                failures.Add(ProofFindings.Failure(task.Before, i, "something other than the words of its new place changed in it."));
                identical = false;
            }
            else if (!Moved(i, ref recent))
            {
                failures.Add(ProofFindings.Failure(
                    task.Before, i, "its words changed although its motion, as far as the program says where it is, did not."));
                identical = false;
            }
            else if (!PlainMotion.Is(task.Before.Motions[motion]) && !IsPlainLead(task.Before.Motions[motion]))
            {
                failures.Add(ProofFindings.Failure(task.Before, i, "it changed although its words alone do not say where it goes."));
            }
        }

        return (identical, failures);
    }

    // The words of an approach or a departure say where it meets the contour; its way follows from that.
    private bool IsPlainLead(in NcMotion motion) => task.Before.IsLead(motion) && PlainMotion.Is(motion with { Kind = MotionKind.Line });

    // The blocks that state a center for arcs behind them, if one of these has another center now, or if the tool stood elsewhere: a
    // center in increments must then change to stay.
    private static HashSet<int> MovedPoles(ProofTask task)
    {
        var (poles, before, after) = (task.Before.Poles, task.Before.Motions, task.After.Motions);
        var moved = new HashSet<int>();
        for (var i = 0; i < poles.Count; i++)
        {
            var end = i + 1 < poles.Count ? poles[i + 1].Motions : before.Length;
            for (var arc = poles[i].Motions; arc < end && arc < before.Length; arc++)
            {
                if (before[arc].Has(MotionFlags.CenterBefore)
                    && (before[arc].Center != after[arc].Center || before[poles[i].Motions].Start != after[poles[i].Motions].Start))
                {
                    moved.Add(poles[i].Block);
                    break;
                }
            }
        }

        return moved;
    }

    private bool Moved(int block, ref int recent)
    {
        for (var run = 0; task.Before.RunOf(block, run, ref recent) is >= 0 and var i; run++)
        {
            var (was, now) = (task.Before.Motions[i], task.After.Motions[i]);
            if (was.Start != now.Start || was.End != now.End || was.Center != now.Center)
            {
                return true;
            }
        }

        return false;
    }
}

/// <summary>Tells whether a block's words alone determine where its motion goes. It lists what is allowed, while the rewriter lists what
/// is not: a case that neither foresees is not a plain motion.</summary>
internal static class PlainMotion
{
    private const MotionFlags Plain = MotionFlags.Inch | MotionFlags.Incremental | MotionFlags.AbsoluteCenter | MotionFlags.ByRadius
        | MotionFlags.CompensationLeft | MotionFlags.CompensationRight | MotionFlags.CompensationSwitches | MotionFlags.StartsElsewhere
        | MotionFlags.CenterBefore | MotionFlags.PolarEnd;

    // A computed word does so, too, if its value is known: the rest of the program says which value its variables have.
    public static bool Is(in NcMotion motion) =>
        ((motion.Flags & ~MotionFlags.Expression) | Plain) == Plain
            && (motion.IsCut || motion.Kind == MotionKind.Rapid)
            && (!motion.Has(MotionFlags.Expression) || (motion.UnknownEnd & motion.Plane.Axes()) == AxisSet.None);
}
