using System.Security.Cryptography;
using ErrorMatching.Json;

namespace ErrorMatching.Cell.Tests;

public sealed class StoredPageTests() : StoreTest(new SqliteKind())
{
    private static (string, SqlArgument)[] Page(Correction correction) => [("PageSha256", correction.PageSha256)];

    [Fact]
    public void A_page_is_drawn_from_its_report_and_takes_no_room()
    {
        var (store, computed, correction) = Compute();
        Assert.Equal(["page"], store.Read("SELECT form FROM content WHERE sha256 = @PageSha256", r => r.GetString(0), Page(correction)));
        Assert.Equal(
            [0L], store.Read("SELECT length(bytes) FROM content WHERE sha256 = @PageSha256", r => r.GetInt64(0), Page(correction)));
        Assert.True(computed.Page.Span.SequenceEqual(store.Content(correction.PageSha256!)));
        Assert.True(computed.Report.Span.SequenceEqual(store.Content(correction.ReportSha256!)));
        Assert.All(CorrectionFiles.Read(store, correction), f => Assert.Null(f.Notice));
    }

    [Fact]
    public void A_page_that_its_report_does_not_give_is_stored_itself()
    {
        var (store, computed, correction) = Compute(page => [.. page, (byte)' ']);
        Assert.Equal(["brotli"], store.Read("SELECT form FROM content WHERE sha256 = @PageSha256", r => r.GetString(0), Page(correction)));
        Assert.Equal([.. computed.Page.Span, (byte)' '], store.Content(correction.PageSha256!));
    }

    // What another version drew: its hash is not that of the page that this version draws.
    [Fact]
    public void A_page_that_this_version_draws_otherwise_is_not_passed_off_as_the_recorded_one()
    {
        var (store, computed, correction) = Compute(page => [.. page, (byte)' ']);
        store.Write(t => t.Execute(
            "UPDATE content SET bytes = @none, form = 'page', source = @ReportSha256, made_by = '0.9.9' WHERE sha256 = @PageSha256",
            [("none", Array.Empty<byte>()), ("ReportSha256", correction.ReportSha256), ("PageSha256", correction.PageSha256)]));
        var redrawn = Assert.Throws<StoreException>(() => store.Content(correction.PageSha256!));
        Assert.Equal(StoreError.Redrawn, redrawn.Error);
        Assert.Contains("0.9.9", redrawn.Message, StringComparison.Ordinal);
        Assert.Contains(correction.ReportSha256!, redrawn.Message, StringComparison.Ordinal);

        var files = CorrectionFiles.Read(store, correction);
        var page = Assert.Single(files, f => f.Notice is not null);
        Assert.Equal("1-report-redrawn.html", page.Name);
        Assert.True(computed.Page.Span.SequenceEqual(page.Bytes.Span));
        Assert.True(computed.Report.Span.SequenceEqual(Assert.Single(files, f => f.Name == "1-report.json").Bytes.Span));
    }

    [Fact]
    public void A_page_whose_report_is_a_page_is_damaged()
    {
        var (store, _, correction) = Compute();
        store.Write(t => t.Execute("UPDATE content SET source = sha256 WHERE form = 'page'"));
        Assert.Equal(StoreError.Damaged, Assert.Throws<StoreException>(() => store.Content(correction.PageSha256!)).Error);
    }

    [Fact]
    public void A_content_of_an_earlier_version_is_read_as_it_is()
    {
        using (StoreOpening.Connect(Settings, d => Migrations.Apply(d, Clock, null, upTo: 6)))
        {
        }

        var plain = Bytes(new string('x', 1000));
        var hash = Convert.ToHexStringLower(SHA256.HashData(plain.Span));
        using (var earlier = StoreOpening.Connect(Settings, _ => { }))
        {
            earlier.Change((connection, transaction) => Sql.Execute(
                connection,
                "INSERT INTO content (sha256, bytes) VALUES (@hash, @bytes)",
                [("hash", hash), ("bytes", plain.ToArray())],
                transaction));
        }

        Assert.Equal(plain.ToArray(), Open().Content(hash));
    }

    private (CellStore Store, ComputedProgram Computed, Correction Correction) Compute(Func<byte[], byte[]>? drawn = null)
    {
        var computed = Samples.Program(Samples.Part("complex-mating"));
        var page = drawn?.Invoke(computed.Page.ToArray()) ?? computed.Page;
        var store = Open();
        var correction = store.Step(
            Recognize(store, store.Archive(Arrival("one", "one")).Correction, "S-1"),
            CorrectionState.Computed,
            "cell",
            "computed",
            c => c with
            {
                ProgramSha256 = ContentHash.Sha256(computed.Program.Span),
                ReportSha256 = ContentHash.Sha256(computed.Report.Span),
                PageSha256 = ContentHash.Sha256(page.Span),
            },
            [computed.Program, computed.Report, page]);
        return (store, computed, correction);
    }
}
