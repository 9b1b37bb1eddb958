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

        return (JointObstacles.Of(change.Result) ?? CompensationEntry.Of(change.Result)) is { } obstacle
            ? obstacle
            : WordEditor.Run(change.Result, keepRadii: wish.Elements.Count == 0);
    }
}
