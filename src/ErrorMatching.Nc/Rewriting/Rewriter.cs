using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Displaces elements or end points of a program and changes only the words that this requires.</summary>
public static class Rewriter
{
    /// <summary>Rewrites a program.</summary>
    /// <param name="path">The original, interpreted.</param>
    /// <param name="wish">What to displace.</param>
    /// <returns>The displaced program, not yet proved, or the reason why it cannot be displaced.</returns>
    public static Outcome<Rewrite> Apply(NcPath path, DisplacementWish wish)
    {
        if (path.Refusal is { } refusal)
        {
            return refusal;
        }

        if (wish.IsZero)
        {
            return Rewrite.None(path);
        }

        var change = wish.Elements.Count == 0 ? EndPointDisplacer.Run(path, wish)
            : PathWithoutPoints.Of(path, wish) is { } reduced ? reduced.Displace(wish)
            : ElementDisplacer.Run(path, wish);
        if (!change.IsUsable)
        {
            return change.Refusal;
        }

        return (JointObstacles.Of(change.Result) ?? CompensationEntry.Earlier(change.Result)) is { } obstacle ? obstacle
            : CompensatedPath.Concerns(path) ? Compensated(path, change.Result)
            : CompensationEntry.Of(change.Result) is { } entry ? entry
            : Edit(change.Result);
    }

    // Under cutter compensation the control must still be able to cut the result. Where its path is not followed, the ways in and out are
    // checked by themselves.
    private static Outcome<Rewrite> Compensated(NcPath path, PathChange change)
    {
        var before = CompensatedPath.Check(path);
        if (before is not null && CompensatedPath.Stops(before))
        {
            return before;
        }

        if ((before is not null || !path.Dialect.Compensation.StartExceedsRadius) && CompensationEntry.Of(change) is { } entry)
        {
            return entry;
        }

        var rewrite = Edit(change);
        return before is null && rewrite.IsUsable
            && CompensatedPath.Check(NcInterpreter.Run(rewrite.Result.Program, path), "displaced as asked, ") is { } after
            ? after
            : rewrite;
    }

    private static Outcome<Rewrite> Edit(PathChange change)
    {
        var rewrite = WordEditor.Run(change);
        if (rewrite.IsUsable && change.Path.UncertainBlocks is { Count: > 0 } uncertain
            && rewrite.Result.ChangedBlocks.Where(uncertain.Contains).Cast<int?>().FirstOrDefault() is { } block)
        {
            return BlockRefusal.At(change.Path.Program, block, NcRefusalCodes.UnknownCondition,
                "it would have to change, and whether it is cut depends on a value that only the machine knows, or on block skip. "
                    + "State that: "
                    + "assume or blockSkip in the job, --assume or --block-skip at the console; or leave out the blocks beside it.");
        }

        return rewrite;
    }
}
