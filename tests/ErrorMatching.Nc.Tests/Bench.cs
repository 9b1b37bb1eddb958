using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc.Tests;

/// <summary>Short ways to read, displace and prove a program in a test.</summary>
internal static class Bench
{
    public static NcPath Read(string text, NcDialect? dialect = null) =>
        NcInterpreter.Run(NcProgram.FromText(text), dialect ?? NcDialects.Generic);

    public static string Text(NcProgram program) => System.Text.Encoding.Latin1.GetString(program.Bytes.Span);

    public static int[] Blocks(NcPath path, params string[] selectors) =>
        BlockSelector.Select(path.Program, [.. selectors.Select(BlockSelector.Parse)]).Result
            ?? throw new InvalidOperationException("No such block.");

    public static NcMotion MotionOf(NcPath path, string block) => path.Motions[path.MotionOf(Blocks(path, block)[0])];

    /// <summary>Displaces to the left, proves, and returns the new text.</summary>
    public static string Normal(string text, double left, string selector, NcDialect? dialect = null) =>
        Displaced(Read(text, dialect), p => DisplacementWish.Normal(p, Blocks(p, selector), left));

    /// <summary>Moves end points, proves, and returns the new text.</summary>
    public static string By(string text, Vector3 by, string selector, NcDialect? dialect = null) =>
        Displaced(Read(text, dialect), p => DisplacementWish.EndsBy(p, Blocks(p, selector), by));

    public static string Displaced(NcPath path, Func<NcPath, Outcome<DisplacementWish>> wanted) =>
        Text(Rewritten(path, Usable(wanted(path))).Program);

    public static Rewrite Rewritten(NcPath path, DisplacementWish wish)
    {
        var rewrite = Usable(Rewriter.Apply(path, wish));
        var proof = Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm);
        Assert.Empty(proof.Failures);
        Assert.True(proof.Holds && proof.UntouchedBytesIdentical);
        return rewrite;
    }

    public static Refusal RefusedNormal(string text, double left, string selector, NcDialect? dialect = null)
    {
        var path = Read(text, dialect);
        var wish = DisplacementWish.Normal(path, Blocks(path, selector), left);
        return wish.Refusal ?? Refused(Rewriter.Apply(path, wish.Result!));
    }

    public static Refusal RefusedBy(string text, Vector3 by, string selector, NcDialect? dialect = null)
    {
        var path = Read(text, dialect);
        var wish = DisplacementWish.EndsBy(path, Blocks(path, selector), by);
        return wish.Refusal ?? Refused(Rewriter.Apply(path, wish.Result!));
    }

    public static T Usable<T>(Outcome<T> outcome)
        where T : class
    {
        Assert.True(outcome.IsUsable, outcome.Refusal?.ToString());
        return outcome.Result;
    }

    public static Refusal Refused<T>(Outcome<T> outcome)
        where T : class
    {
        Assert.False(outcome.IsUsable, "It was not refused.");
        return outcome.Refusal;
    }
}
