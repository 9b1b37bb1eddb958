using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>A path without straight cuts of length zero, which remain when a corner cuts off a short piece, and without steps in depth at
/// a corner: feeds along the tool axis between two displaced elements. Elements on both sides are neighbors, so they are displaced on
/// this path and the result is mapped back to the program's own.</summary>
internal sealed class PathWithoutPoints
{
    private readonly NcPath _original;
    private readonly NcPath _reduced;
    private readonly int[] _kept;

    private PathWithoutPoints(NcPath original, NcPath reduced, int[] kept)
    {
        _original = original;
        _reduced = reduced;
        _kept = kept;
    }

    /// <summary>The path without points and steps; null if it has none.</summary>
    public static PathWithoutPoints? Of(NcPath path, DisplacementWish wish)
    {
        var steps = Steps(path.Motions, wish.Elements);
        if (!path.Motions.HasPoints && steps.Count == 0)
        {
            return null;
        }

        var kept = new List<int>(path.Motions.Length);
        for (var i = 0; i < path.Motions.Length; i++)
        {
            if (!path.Motions[i].IsPoint && !steps.Contains(i))
            {
                kept.Add(i);
            }
        }

        var motions = new NcMotions();
        foreach (var i in kept)
        {
            motions.Add(path.Motions[i]);
        }

        var dependents = path.PlaceDependents.Select(d => (d.Block, kept.BinarySearch(d.Joint) is var at && at < 0 ? ~at : at)).ToArray();
        var reduced = new NcPath(
            path.Program, path.Dialect, motions, path.Problems, dependents, path.Frames, path.Notes, path.Refusal, path.Library)
        {
            UncertainBlocks = path.UncertainBlocks,
            ToolChanges = [.. path.ToolChanges.Select(c => kept.BinarySearch(c) is var at && at < 0 ? ~at : at)],
        };
        return new(path, reduced, [.. kept]);
    }

    /// <summary>Displaces elements. Ignores a wish for a point.</summary>
    public Outcome<PathChange> Displace(DisplacementWish wish)
    {
        var elements = new List<ElementWish>(wish.Elements.Count);
        foreach (var element in wish.Elements)
        {
            var place = Array.BinarySearch(_kept, element.Motion);
            if (place >= 0)
            {
                elements.Add(element with { Motion = place });
            }
        }

        var change = ElementDisplacer.Run(_reduced, DisplacementWish.OfElements(elements));
        return change.IsUsable ? Restore(change.Result) : change;
    }

    // Feeds along the tool axis directly between two elements.
    private static MotionRuns Steps(NcMotions motions, IReadOnlyList<ElementWish> elements)
    {
        var steps = new MotionRuns();
        for (var i = 1; i < elements.Count; i++)
        {
            var (before, behind) = (elements[i - 1].Motion, elements[i].Motion);
            if (behind == before + 1)
            {
                continue;
            }

            var next = before + 1;
            while (next < behind && IsStep(motions[next]) && motions.IsComparable(next, before))
            {
                next++;
            }

            if (next < behind || !motions.IsComparable(behind, before))
            {
                continue;
            }

            for (var step = before + 1; step < behind; step++)
            {
                steps.Add(step);
            }
        }

        return steps;
    }

    private static bool IsStep(in NcMotion motion) =>
        motion is { Kind: MotionKind.Line, MovesInPlane: false } && !motion.Has(MotionFlags.MachineMove);

    private PathChange Restore(PathChange reduced)
    {
        var change = new PathChange(_original);
        var next = 0;
        for (var joint = 0; joint <= _original.Motions.Length; joint++)
        {
            // The joints on both sides of a point or step are one place.
            if (reduced.IsSet(next))
            {
                change.Move(joint, reduced.MoveOf(next));
            }

            if (next < _kept.Length && _kept[next] == joint)
            {
                next++;
            }
        }

        foreach (var motion in reduced.ArcsWithCenter())
        {
            change.SetCenter(_kept[motion], reduced.CenterOf(motion, _reduced.Motions[motion]));
        }

        return change;
    }
}
