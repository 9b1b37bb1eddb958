using ErrorMatching.Json;

namespace ErrorMatching.Cell.Tests;

public sealed class CheckedContentsTests : PeopleTest
{
    [Fact]
    public void Verification_says_how_much_it_looked_at()
    {
        var store = Filled();
        var finding = new AuditTrail(store, Keys).Verify();
        Assert.True(finding.Holds, finding.Message);
        Assert.Equal((2L, 2L * Program.Length, 0L), (finding.Contents, finding.ContentBytes, finding.Pages));
    }

    // Each byte of the compressed row, its length, and how it is stored.
    [Fact]
    public void A_mutated_content_is_named()
    {
        var store = Filled();
        var hash = ContentHash.Sha256(Program);
        var packed = PackedContent.Of(Program);
        for (var at = 0; at < packed.Bytes.Length; at += 3)
        {
            byte[] mutated = [.. packed.Bytes];
            mutated[at] ^= (byte)(1 << (at % 8));
            Put(packed with { Bytes = mutated });

            // Some bits of a stream mean nothing: then the content is what was kept.
            var isSame = (packed with { Bytes = mutated }).Plain() is { } plain && plain.AsSpan().SequenceEqual(Program);
            Assert.Equal(isSame, Named(store, hash) is null);
        }

        foreach (var other in new[]
        {
            packed with { Length = 5 }, packed with { Length = null }, packed with { Form = "zip" }, packed with { Form = null },
            packed with { Bytes = [] },
        })
        {
            Put(other);
            Assert.Equal(AuditFaultKind.RowDiffers, Named(store, hash)!.Kind);
        }

        Put(packed);
        Assert.Null(Named(store, hash));

        void Put(PackedContent content) => store.Database.Change((connection, transaction) => Sql.Execute(
            connection,
            "UPDATE content SET bytes = @Bytes, form = @Form, length = @Length WHERE sha256 = @hash",
            [("Bytes", content.Bytes), ("Form", content.Form), ("Length", content.Length), ("hash", hash)],
            transaction));
    }

    [Fact]
    public void A_content_that_is_gone_is_named_with_its_correction()
    {
        var store = Filled();
        store.Database.Read(connection => Sql.Execute(
            connection,
            "PRAGMA foreign_keys = OFF; DELETE FROM content WHERE sha256 = @Hash",
            [("Hash", ContentHash.Sha256(Program))]));
        var fault = Named(store, ContentHash.Sha256(Program))!;
        Assert.Equal(Recorded.ContentMissing.With(ContentHash.Sha256(Program), 1L), fault.Statement);
    }

    private static byte[] Program { get; } = System.Text.Encoding.UTF8.GetBytes(
        string.Concat(Enumerable.Range(0, 60).Select(i => $"N{i} G1 X{i * i % 97}.25 F500\n")));

    private static AuditFault? Named(CellStore store, string hash)
    {
        var fault = store.Database.TwoSnapshots((connection, transaction, second) =>
            new CheckedContents().Fault(connection, transaction, second, null, TestContext.Current.CancellationToken));
        Assert.True(fault is null || fault.Message.Contains(hash, StringComparison.Ordinal), fault?.Message);
        return fault;
    }

    private CellStore Filled()
    {
        byte[] measurement = [.. Program.Reverse()];
        var c = Store.Archive(new Arrival("gauge", "one.csv", "one", measurement)).Correction;
        c = Store.Step(c, CorrectionState.Recognized, "cell", "by name", x => x with { Job = "job", Machine = "mill", Slot = "1" });
        Store.Step(
            c, CorrectionState.Computed, "cell", "computed", x => x with { ProgramSha256 = ContentHash.Sha256(Program) }, [Program]);
        return Store;
    }
}
