using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Cell.Tests;

public sealed class CorrectionIdentityTests
{
    private static readonly string A = new('a', 64);
    private static readonly string B = new('b', 64);
    private static readonly string C = new('c', 64);

    // By sha256sum over the same lines.
    [Fact]
    public void Identity_is_the_hash_of_the_lines_that_the_documentation_names()
    {
        Assert.Equal("b20e50cef8b9ac14123b5d2fb7d5ce7efe9f2bf690008732cefa01812f4490a7", CorrectionIdentity.Of([A], B, C, null));
        Assert.Equal("0c7a43121eb9f14f1cfcd08f785d6042046d1d90bdb3de721a3bfb675bdbed9a", CorrectionIdentity.Of([A, C], B, null, 0.5));
    }

    [Fact]
    public void Whatever_differs_makes_another_identity()
    {
        string[] all =
        [
            CorrectionIdentity.Of([A], B, C, null), CorrectionIdentity.Of([B], B, C, null), CorrectionIdentity.Of([A], A, C, null),
            CorrectionIdentity.Of([A], B, A, null),
            CorrectionIdentity.Of([A], B, null, null), CorrectionIdentity.Of([A], B, C, 1), CorrectionIdentity.Of([A], B, C, 0.5),
            CorrectionIdentity.Of([A, A], B, C, null),
            CorrectionIdentity.Of([A, B], B, C, null), CorrectionIdentity.Of([B, A], B, C, null),
        ];
        Assert.Equal(all.Length, all.Distinct().Count());
    }

    [Fact]
    public void Same_inputs_make_one_identity_and_other_inputs_another()
    {
        var hash = Gen.Elements(A, B, C);
        var input = from measurements in Gen.NonEmptyListOf(hash)
                    from job in hash
                    from origin in Gen.Elements(A, B, C, null)
                    from gain in Gen.Elements<double?>(null, 0.1, 0.1 + 1e-16, 1, 2)
                    select (Measurements: string.Join(' ', measurements), Job: job, Base: origin, Gain: gain);
        Prop.ForAll(Arb.From(Gen.Two(input)), pair =>
        {
            var (one, other) = pair;
            return (Of(one) == Of(other)) == (one == other);
        }).QuickCheckThrowOnFailure();

        static string Of((string Measurements, string Job, string? Base, double? Gain) i) =>
            CorrectionIdentity.Of(i.Measurements.Split(' '), i.Job, i.Base, i.Gain);
    }

    [Fact]
    public void What_is_no_hash_has_no_identity()
    {
        Assert.Throws<ArgumentException>(() => CorrectionIdentity.Of([], A, B, null));
        foreach (var hash in new[] { "", "abc", new string('A', 64), new string('a', 63) + "\n", new string('a', 65) })
        {
            Assert.Throws<ArgumentException>(() => CorrectionIdentity.Of([hash], A, B, null));
            Assert.Throws<ArgumentException>(() => CorrectionIdentity.Of([A], hash, B, null));
            Assert.Throws<ArgumentException>(() => CorrectionIdentity.Of([A], B, hash, null));
        }
    }
}
