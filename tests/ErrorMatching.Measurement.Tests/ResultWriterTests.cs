using System.Text;
using ErrorMatching.Geometry;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Measurement.Tests;

public class ResultWriterTests
{
    private static readonly PieceResult Cover = new("Cover & housing", new('a', 64), [
        new("P1", new(1, 2, 0), new(1.0125, 2, 0), new(1, 0, 0), 0.0125) { HasZ = false, Limits = (-0.02, 0.01) },
        new("2a", new(-3, 4.5, 0), new(-3, 4.4999996, 0), new(0, 1, 0), -4e-7) { HasZ = false, Limits = (-0.02, 0.01) },
        new("<ß>", new(0, 0, 7), new(1e-9, -1e-9, 7.25), new(0, 0.6, 0.8), 0.25) { Limits = (0, 0.5) },
        new("free", new(0, 0, 0), new(0, 0, 0), new(0, 0, 1), 0)])
    {
        WorkOrder = "WO-1",
    };

    [Fact]
    public void A_document_is_valid_qif_and_our_own_reader_reads_it_back()
    {
        var text = Encoding.UTF8.GetString(QifWriter.Write(Cover));
        Assert.Empty(QifSchema.Check(text));
        var file = Text.Read(text, null, "cover.qif");
        Assert.Equal(["P1", "2a", "<ß>", "free"], file.Points.Select(p => p.Label));
        Assert.Equal([new(1.0125, 2, 0), new(-3, 4.5, 0), new(0, 0, 7.25), default(Point3)], file.Points.Select(p => p.Position));
        Assert.Equal(Cover.Points.Select(p => p.Nominal), file.Nominals.Select(p => p.Position));
        Assert.StartsWith("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n", text, StringComparison.Ordinal);
        Assert.DoesNotContain('\r', text);
        Assert.Equal(text, Encoding.UTF8.GetString(QifWriter.Write(Cover)));
    }

    [Fact]
    public void A_file_is_valid_aqdef_and_our_own_reader_reads_it_back()
    {
        var text = Encoding.UTF8.GetString(AqdefWriter.Write(Cover));
        Assert.Empty(AqdefRules.Check(text));
        var file = Text.Read(text, null, "cover.dfq");
        Assert.Equal(["P1", "2a", "<ß>", "free"], file.Points.Select(p => p.Label));
        Assert.Equal([new(1.0125, 2, 0), new(-3, 4.5, 0), new(0, 0, 7.25), default(Point3)], file.Points.Select(p => p.Position));
        Assert.Equal([false, false, true, true], file.Points.Select(p => p.HasZ));
        Assert.Equal(Cover.Points.Select(p => p.Nominal), file.Nominals.Select(p => p.Position));
        Assert.Equal(["Cover & housing", "Cover & housing", "WO-1"], file.HeaderFields.Select(f => f.Value));
        Assert.Contains("\nK2002/3 P1.N\n", text, StringComparison.Ordinal);
        Assert.Contains("\nK2110/3 -0.02\nK2111/3 0.01\n", text, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0.0125, -0.02, 0.01, "FAIL")]
    [InlineData(0.01, -0.02, 0.01, "PASS")]
    [InlineData(-0.02, -0.02, 0.01, "PASS")]
    [InlineData(-0.0201, -0.02, 0.01, "FAIL")]
    public void A_status_says_whether_the_deviation_is_within_its_limits(double deviation, double lower, double upper, string status)
    {
        var point = new PointResult("1", default, default, new(0, 0, 1), deviation) { Limits = (lower, upper) };
        var text = Encoding.UTF8.GetString(QifWriter.Write(new("n", "", [point])));
        Assert.Empty(QifSchema.Check(text));
        Assert.Contains($"<CharacteristicStatusEnum>{status}<", text, StringComparison.Ordinal);
        Assert.Contains($"<InspectionStatusEnum>{status}<", text, StringComparison.Ordinal);
        Assert.Contains("<ToleranceValue>0.03<", text, StringComparison.Ordinal);
        Assert.Contains("<OuterDisposition>0.01<", text, StringComparison.Ordinal);
    }

    [Fact]
    public void Without_limits_nothing_is_judged()
    {
        var text = Encoding.UTF8.GetString(QifWriter.Write(new("n", "", [Cover.Points[3]])));
        Assert.Empty(QifSchema.Check(text));
        Assert.Contains("<InspectionStatusEnum>UNKNOWN<", text, StringComparison.Ordinal);
        Assert.DoesNotContain("Characteristic", text, StringComparison.Ordinal);
    }

    [Fact]
    public void The_identifier_depends_on_the_result()
    {
        Assert.NotEqual(Identifier(Cover), Identifier(Cover with { Sha256 = new('b', 64) }));
        Assert.NotEqual(Identifier(Cover), Identifier(Cover with { Points = [.. Cover.Points.Skip(1)] }));

        static string Identifier(PieceResult piece) =>
            Encoding.UTF8.GetString(QifWriter.Write(piece)).Split("<QPId>")[1].Split("</QPId>")[0];
    }

    // Names of any characters, and coordinates of any size that a machine has.
    [Fact]
    public void Any_result_is_valid_and_read_back() =>
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(100), Prop.ForAll<int, NonEmptyArray<string?>>(IsReadBack));

    private static void IsReadBack(int seed, NonEmptyArray<string?> names)
    {
        var random = new Random(seed);
        double Next(double size) => Math.Round((random.NextDouble() - 0.5) * size, 6);
        var labels = names.Get.Select((n, i) => $"{i} {n}").Where(l => l.Length < 70 && !l.Any(c => c < ' ' || c == '\u007f')).ToArray();
        if (labels.Length == 0)
        {
            return;
        }

        var piece = new PieceResult(names.Get[0] ?? "-", "", [
            .. labels.Select(l => new PointResult(
                l, new(Next(1e3), Next(1e3), Next(1e3)), new(Next(1e3), Next(1e3), Next(1e3)), new(0, 0, 1), Next(1))
            {
                Limits = random.Next(2) == 0 ? null : (-Math.Abs(Next(1)), Math.Abs(Next(1))),
            })]);
        var qif = Encoding.UTF8.GetString(QifWriter.Write(piece));
        Assert.Empty(QifSchema.Check(qif));
        Assert.Equal(piece.Points.Select(p => p.Actual), Text.Read(qif, null, "p.qif").Points.Select(p => p.Position));
        Assert.Equal(
            piece.Points.Select(p => p.Actual),
            Text.Read(Encoding.UTF8.GetString(AqdefWriter.Write(piece)), null, "p.dfq").Points.Select(p => p.Position));
    }

    [Theory]
    [InlineData("<Scope>Results</Scope>", "")]
    [InlineData("<FeatureItemId>8<", "<FeatureItemId>4<")]
    [InlineData("PointFeatureItem id=\"8\"", "PointFeatureItem id=\"7\"")]
    [InlineData("FeatureItems n=\"4\"", "FeatureItems n=\"3\"")]
    [InlineData("idMax=\"", "idMax=\"1")]
    [InlineData("versionQIF=\"3.0.0\"", "versionQIF=\"2.1.0\"")]
    [InlineData("<Location>1 2 0<", "<Location>1 2<")]
    [InlineData("<FormalStandardId>1<", "<FormalStandardId>2<")]
    [InlineData("InspectionStatusEnum>FAIL<", "InspectionStatusEnum>BAD<")]
    public void The_check_of_documents_sees_what_is_wrong(string good, string bad)
    {
        var text = Encoding.UTF8.GetString(QifWriter.Write(Cover));
        Assert.Contains(good, text, StringComparison.Ordinal);
        var at = text.IndexOf(good, StringComparison.Ordinal);
        Assert.NotEmpty(QifSchema.Check(text[..at] + bad + text[(at + good.Length)..]));
    }

    [Theory]
    [InlineData("K0100 14", "K0100 13")]
    [InlineData("K2001/3 3\n", "")]
    [InlineData("K2110/3 -0.02", "K2110/3 0.02")]
    [InlineData("K2101/1 1", "K2101/1 wide")]
    [InlineData("K1001 ", "K1001 far too long for a number of a part")]
    [InlineData("1.0125\u00140", "\u00140")]
    [InlineData("\u000f", "")]
    public void The_check_of_files_sees_what_is_wrong(string good, string bad)
    {
        var text = Encoding.UTF8.GetString(AqdefWriter.Write(Cover));
        Assert.Contains(good, text, StringComparison.Ordinal);
        var at = text.IndexOf(good, StringComparison.Ordinal);
        Assert.NotEmpty(AqdefRules.Check(text[..at] + bad + text[(at + good.Length)..]));
    }
}
