using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement.Tests;

public class OwnFormatTests
{
    public static TheoryData<string> Files => [.. OwnFormats.All.Keys];

    [Theory]
    [MemberData(nameof(Files))]
    public void A_file_is_read_as_what_it_shows_itself_to_be(string name)
    {
        MeasurementFormat[] formats = [MeasurementFormat.Points, MeasurementFormat.FeatureTable, MeasurementFormat.Recognized];
        foreach (var format in formats)
        {
            var file = Text.Read(OwnFormats.All[name], format, name);
            Assert.Equal(["P1", "P2"], file.Points.Select(p => p.Label));
            Assert.Equal([new(32.012, 5.998, 0.001), new Point3(-1.5, 20.25, -3)], file.Points.Select(p => p.Position));
            Assert.Equal([new(32, 6, 0), new Point3(-1.5, 20, -3)], file.Nominals.Select(p => p.Position));
            Assert.All(file.Points, p => Assert.True(p.HasZ && p.Line > 1));
            Assert.Equal(LengthUnit.Millimeter, file.Unit);
            Assert.Equal(MeasurementError.MissingPoint, Assert.Throws<InputException>(() => file["P3"]).Code);
        }
    }

    [Theory]
    [MemberData(nameof(Files))]
    public void A_description_with_columns_is_followed_to_the_letter(string name) =>
        Assert.Throws<InputException>(() => Text.Read(
            OwnFormats.All[name], Text.Format("""{ "columns": { "label": "Nr" } }"""), name));

    [Theory]
    [InlineData("part.qif", "<Factor>0.001", "<Factor>0.0254")]
    [InlineData("part.dfq", "K2142/0 mm", "K2142/0 in")]
    [InlineData("part.dmo", "UNITS/MM", "UNITS/INCH")]
    [InlineData("part_chr.txt", "\tmm", "\tinch")]
    [InlineData("part.txt", "UNITS=MM", "UNITS=IN")]
    public void Inches_are_converted(string name, string millimeters, string inches)
    {
        var file = Text.Read(OwnFormats.All[name].Replace(millimeters, inches, StringComparison.Ordinal), null, name);
        Assert.Equal(LengthUnit.Inch, file.Unit);
        Assert.Equal((514.35, 508), (file["P2"].Position.Y, file.Nominals[1].Position.Y));
    }

    [Theory]
    [InlineData("part.qif", "ModelNumber", "4711")]
    [InlineData("part.qif", "SerialNumber", "17")]
    [InlineData("part.dfq", "K1001", "4711")]
    [InlineData("part.dmo", "PARTID", "4711")]
    [InlineData("part.dmo", "FILNAM", "COVER")]
    [InlineData("part_chr.txt", "partnb", "17")]
    [InlineData("part.txt", "SER NUMBER", "17")]
    public void What_a_file_says_about_its_piece_is_a_header_field(string name, string field, string value)
    {
        var file = Text.Read(OwnFormats.All[name], null, name);
        Assert.Equal(value, Assert.Single(file.HeaderFields, f => f.Name == field).Value);
        Assert.Equal(
            SourceSide.Part, new SourceRules([SourceRule.OfHeaderField(field, $"^{value}$")], []).Decide(file));
    }

    [Fact]
    public void A_table_of_characteristics_has_columns_for_rules() =>
        Assert.Equal(
            SourceSide.Part,
            new SourceRules([SourceRule.OfColumn("planid", "^COVER$")], []).Decide(Text.Read(OwnFormats.Calypso, null, "chr.txt")));

    [Theory]
    [InlineData("part.qif", "UTF-8", "utf-16", "utf-16")]
    [InlineData("part.dmo", "gauge", "Prüfer Müller", "windows-1252")]
    [InlineData("part.dfq", "K1002 Cover", "K1002 Gehäuse", "windows-1252")]
    [InlineData("part_chr.txt", "Bore", "Größe", "utf-16")]
    [InlineData("part.txt", "COVER", "Gehäuse", "utf-8")]
    public void Encodings_are_those_of_gauges(string name, string word, string other, string encoding)
    {
        var text = OwnFormats.All[name].Replace(word, other, StringComparison.Ordinal);
        var bytes = encoding == "utf-16" ? [.. Encoding.Unicode.Preamble, .. Encoding.Unicode.GetBytes(text)]
            : encoding == "utf-8" ? Encoding.UTF8.GetBytes(text) : Encoding.Latin1.GetBytes(text);
        Assert.Equal(2, MeasurementReader.Read(bytes, name, MeasurementFormat.Points).Points.Count);
    }

    [Theory]
    [InlineData("part.qif", "</QIFDocument>", "", MeasurementError.BadStructure)]
    [InlineData("part.qif", "0fd3e7a0", "&#0;", MeasurementError.BadStructure)]
    [InlineData("part.qif", "32.012 5.998", "32.012", MeasurementError.BadStructure)]
    [InlineData("part.qif", "32.012 5.998", "32.012 NaN", MeasurementError.NotANumber)]
    [InlineData("part.qif", "32.012 5.998", "32.012 1e7", MeasurementError.ImplausibleNumber)]
    [InlineData("part.qif", "qif3\"", "qif2\"", MeasurementError.UnsupportedVersion)]
    [InlineData("part.qif", "<Factor>0.001", "<Factor>1", MeasurementError.UnknownUnit)]
    [InlineData("part.qif", "<Factor>0.001</Factor>", "", MeasurementError.UnknownUnit)]
    [InlineData("part.qif", "<Location>32.012", "<Location linearUnit=\"inch\">32.012", MeasurementError.UnknownUnit)]
    [InlineData("part.qif", "id=\"7\"", "id=\"6\"", MeasurementError.BadStructure)]
    [InlineData("part.qif", "<FeatureItemId>6", "<FeatureItemId>66", MeasurementError.BadStructure)]
    [InlineData("part.qif", "<FeatureName>P2", "<FeatureName>P1", MeasurementError.DuplicatePoint)]
    [InlineData("part.qif", "<FeatureName>P2", "<FeatureName>", MeasurementError.EmptyCell)]
    [InlineData(
        "part.qif",
        "</MeasurementResultsSet>",
        "<MeasurementResults id=\"20\"/></MeasurementResultsSet>",
        MeasurementError.SeveralMeasurements)]
    [InlineData("part.dfq", "K0100 7", "K0100 0", MeasurementError.BadStructure)]
    [InlineData("part.dfq", "K0100 7", "K0100 6", MeasurementError.BadStructure)]
    [InlineData("part.dfq", "K0100 7", "K0100 8", MeasurementError.BadStructure)]
    [InlineData("part.dfq", "K2002/2", "K2002/x", MeasurementError.BadStructure)]
    [InlineData("part.dfq", "K2142/0 mm", "K2142/0 cm", MeasurementError.UnknownUnit)]
    [InlineData("part.dfq", "K2112/1 -0.05", "K2142/1 in", MeasurementError.UnknownUnit)]
    [InlineData("part.dfq", "K1002 Cover", "K1001/2 4712", MeasurementError.SeveralMeasurements)]
    [InlineData("part.dfq", "K1002 Cover", "K0100 7", MeasurementError.SeveralMeasurements)]
    [InlineData("part.dfq", "20.25", "20.25x", MeasurementError.TextForNumber)]
    [InlineData("part.dfq", "K2101/1 32.000", "K2101/1 wide", MeasurementError.TextForNumber)]
    [InlineData("part.dfq", "K2002/7 P2 z", "K2002/7 P2.Y", MeasurementError.DuplicatePoint)]
    [InlineData("part.dfq", "Bore diameter", "P3.X", null)]
    [InlineData("part.dfq", "-3\u00140", "-3\u00140\u000f", null)]
    [InlineData("part.dfq", "8.01\u00140", "", null)]
    [InlineData("part.dmo", "UNITS/MM", "UNITS/CM", MeasurementError.UnknownUnit)]
    [InlineData("part.dmo", "PN(PART)=PARTID/'4711'", "UNITS/INCH", MeasurementError.UnknownUnit)]
    [InlineData("part.dmo", "FA(P2) = FEAT/POINT,CART,-1.5", "FA(P2) = FEAT/POINT,POL,-1.5", MeasurementError.BadStructure)]
    [InlineData("part.dmo", "CART,-1.5,20.25,-3.0,0.0,1.0,0.0", "CART,-1.5,20", MeasurementError.BadStructure)]
    [InlineData("part.dmo", "-1.5,20.25", "-1.5,", MeasurementError.EmptyCell)]
    [InlineData("part.dmo", "CART,32.012,5.998,0.001", "CART,32.013,5.998,0.001", MeasurementError.DuplicatePoint)]
    [InlineData("part.dmo", "ENDFIL", "ENDFIL$", MeasurementError.BadStructure)]
    [InlineData("part_chr.txt", "COVER\t17\tP2_Z", "COVER\t18\tP2_Z", MeasurementError.SeveralMeasurements)]
    [InlineData("part_chr.txt", "END", "END\r\nplanid", MeasurementError.SeveralMeasurements)]
    [InlineData("part_chr.txt", "\tmm\r\nEND", "\tcm\r\nEND", MeasurementError.UnknownUnit)]
    [InlineData("part_chr.txt", "5.9980000", "", MeasurementError.EmptyCell)]
    [InlineData("part_chr.txt", "-0.0020000", "0.0020000", MeasurementError.InconsistentDeviation)]
    [InlineData("part_chr.txt", "P2_Z\tzValue\tZ\t-3.0000000\t-3.0000000\t\t\t0.0000000\t\t\tmm", "P2_Z\tzVal", MeasurementError.ShortRow)]
    [InlineData("part_chr.txt", "P2_Y\tyValue", "P2_X\txValue", MeasurementError.DuplicatePoint)]
    [InlineData("part.txt", "LOCATION OF POINT P2  UNITS=MM", "LOCATION OF POINT P1  UNITS=MM", MeasurementError.DuplicatePoint)]
    [InlineData("part.txt", "LOCATION OF POINT P2  UNITS=MM", "LOCATION OF POINT P2  UNITS=CM", MeasurementError.UnknownUnit)]
    [InlineData("part.txt", "LOCATION OF POINT P2  UNITS=MM", "LOCATION OF P2  UNITS=MM", MeasurementError.BadStructure)]
    [InlineData("part.txt", "     5.998     -0.002", "     5.998      0.002", MeasurementError.InconsistentDeviation)]
    [InlineData("part.txt", "     5.998     -0.002", "     5.9x8     -0.002", MeasurementError.ShortRow)]
    [InlineData("part.txt", "      5.998     -0.002      0.000 ----#----", "", MeasurementError.ShortRow)]
    public void A_damaged_file_is_named_by_code_and_line(string name, string good, string bad, string? code)
    {
        var text = OwnFormats.All[name];
        Assert.Contains(good, text, StringComparison.Ordinal);
        var at = text.LastIndexOf(good, StringComparison.Ordinal);
        text = text[..at] + bad + text[(at + good.Length)..];
        if (code is null)
        {
            Assert.Equal(2, Text.Read(text, null, name).Points.Count);
            return;
        }

        var error = Assert.Throws<InputException>(() => Text.Read(text, null, name));
        Assert.Equal((code, name), (error.Code, error.File));
        Assert.True(error.Place.Line > 0 && error.Place.Column > 0);
        Assert.NotEmpty(error.Refusals[0].Expected);
    }

    [Theory]
    [InlineData("part.dfq", "K2002/2 P1.Y", "K2002/2 P1")]
    [InlineData("part.dfq", "5,998\u00140", "5,998\u0014255")]
    [InlineData("part.dfq", "5,998\u00140", "\u00140")]
    [InlineData("part_chr.txt", "P1_Y\tyValue", "P1_Y\tradius")]
    [InlineData("part.txt", "Y        6.000", "R        6.000")]
    public void A_point_without_a_coordinate_is_named_where_a_job_needs_it(string name, string good, string bad)
    {
        var file = Text.Read(OwnFormats.All[name].Replace(good, bad, StringComparison.Ordinal), null, name);
        Assert.Equal("P2", Assert.Single(file.Points).Label);
        var error = Assert.Throws<InputException>(() => file["P1"]);
        Assert.Equal(MeasurementError.MissingCoordinate, error.Code);
        Assert.Contains("\"P1\" without Y", error.Message, StringComparison.Ordinal);
        Assert.True(error.Place.Line > 1);
    }

    [Theory]
    [InlineData("part.qif", "<MeasuredFeatures n=\"3\">", "<MeasuredFeatures/><Nothing>", "</MeasuredFeatures>", "</Nothing>")]
    [InlineData("part.dmo", "FA(P1)", "FX(P1)", "FA(P2)", "FX(P2)")]
    [InlineData("part.txt", "LOCATION OF", "POSITION OF", "?", "?")]
    [InlineData("part_chr.txt", "xValue", "radius", "yValue", "radius")]
    public void A_file_without_points_is_refused(string name, string a, string b, string c, string d)
    {
        var text = OwnFormats.All[name].Replace(a, b, StringComparison.Ordinal).Replace(c, d, StringComparison.Ordinal);
        var error = Assert.Throws<InputException>(() => Text.Read(text, null, name));
        Assert.Contains(error.Code, (string[])[MeasurementError.NoPoints, MeasurementError.MissingCoordinate]);
    }

    [Theory]
    [InlineData("<!DOCTYPE q [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]>", "&b;")]
    [InlineData("<!DOCTYPE q SYSTEM \"file:///etc/passwd\">", "")]
    [InlineData("<!DOCTYPE q [<!ENTITY x SYSTEM \"file:///etc/passwd\">]>", "&x;")]
    public void A_document_type_is_refused_and_nothing_outside_is_opened(string type, string reference)
    {
        var text = OwnFormats.Qif.Replace("?>\n", "?>\n" + type + "\n", StringComparison.Ordinal)
            .Replace("0fd3e7a0", reference, StringComparison.Ordinal);
        var error = Assert.Throws<InputException>(() => Text.Read(text, null, "part.qif"));
        Assert.Equal((MeasurementError.BadStructure, 2), (error.Code, error.Place.Line));
    }

    [Fact]
    public void Elements_in_one_another_are_limited() =>
        Assert.Equal(
            MeasurementError.BadStructure,
            Assert.Throws<InputException>(() => Text.Read(
                OwnFormats.Qif.Replace("<QPId>", string.Concat(Enumerable.Repeat("<a>", 1000)), StringComparison.Ordinal))).Code);

    [Fact]
    public void A_file_that_describes_itself_is_limited_too()
    {
        var big = new byte[(1 << 26) + 1];
        OwnFormats.Bytes(OwnFormats.Dmis).CopyTo(big, 0);
        Assert.Equal(
            MeasurementError.FileTooLarge,
            Assert.Throws<InputException>(() => MeasurementReader.Read(big, "part.dmo", MeasurementFormat.Points)).Code);
    }

    // Megabytes of one character, which a reader must not turn into millions of strings.
    [Theory]
    [InlineData("part.dfq", "\u000f")]
    [InlineData("part.dfq", "\u0014")]
    [InlineData("part.dfq", "K2142/0 mm\n")]
    [InlineData("part.dmo", ",")]
    [InlineData("part.dmo", "A(B)=C/D\n")]
    [InlineData("part_chr.txt", "a\t")]
    [InlineData("part.txt", "X 1\n")]
    [InlineData("part.txt", "X 1 ")]
    [InlineData("part.csv", ";")]
    [InlineData("part.csv", "a\n;")]
    public void A_long_file_of_nothing_costs_little_more_than_its_text(string name, string part)
    {
        var head = OwnFormats.All.TryGetValue(name, out var text) ? text.Replace("K0100 7", "K0100 1000000", StringComparison.Ordinal) : "";
        var bytes = OwnFormats.Bytes(head + string.Concat(Enumerable.Repeat(part, 8_000_000 / part.Length)));
        var before = GC.GetAllocatedBytesForCurrentThread();
        _ = Survives(bytes, name);
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 400_000_000);
    }

    // Truncated at every byte of the file.
    [Theory]
    [MemberData(nameof(Files))]
    public void A_file_that_is_cut_off_is_read_or_named(string name)
    {
        var bytes = OwnFormats.Bytes(OwnFormats.All[name]);
        for (var length = 0; length < bytes.Length; length++)
        {
            Survives(bytes[..length], name);
        }
    }

    [Fact]
    public void Random_bytes_are_read_or_named_and_nothing_else()
    {
        var random = new Random(22093);
        var (read, named) = (0, 0);
        var seeds = OwnFormats.All.ToArray();
        for (var i = 0; i < 20_000; i++)
        {
            var (name, text) = seeds[i % seeds.Length];
            _ = Survives(MutationTests.Mutate(OwnFormats.Bytes(text), random), name) ? read++ : named++;
        }

        Assert.True(read > 1000 && named > 4000, $"{read} read, {named} named");
    }

    [Fact]
    public void Values_are_read_with_the_description_next_to_them()
    {
        using var folder = new TemporaryFolder();
        var (description, values) = Split();
        folder.Write("part.dfd", description);
        var path = folder.Write("part.dfx", values);
        var file = MeasurementReader.Read(path, MeasurementFormat.Points);
        Assert.Equal([new(32.012, 5.998, 0.001), new Point3(-1.5, 20.25, -3)], file.Points.Select(p => p.Position));
        Assert.Equal(["part.dfx", "part.dfd"], file.Files.Select(f => Path.GetFileName(f)));
        Assert.Equal("part.dfd", Path.GetFileName(Assert.Throws<InputException>(() => MeasurementReader.Read(
            Rewrite(folder, description.Replace("K2101/1 32.000", "K2101/1 wide", StringComparison.Ordinal), values),
            MeasurementFormat.Points)).File));

        // cat part.dfd part.dfx | sha256sum
        Assert.Equal(Convert.ToHexStringLower(SHA256.HashData(OwnFormats.Bytes(description + values))), file.Sha256);
    }

    // As a cell stores them. The description may end within a line, and the values begin with a mark of their encoding.
    [Theory]
    [InlineData("\n", "")]
    [InlineData("", "\uFEFF")]
    public void Values_behind_their_description_are_one_file(string end, string mark)
    {
        var (description, values) = Split();
        byte[] marked = [.. Encoding.UTF8.GetBytes(mark), .. OwnFormats.Bytes(values)];
        var joined = MeasurementBytes.Joined(OwnFormats.Bytes(description.TrimEnd('\n') + end), marked);
        var file = MeasurementReader.Read(joined, "part.dfx", MeasurementFormat.Points);
        Assert.Equal([new(32.012, 5.998, 0.001), new Point3(-1.5, 20.25, -3)], file.Points.Select(p => p.Position));
    }

    [Fact]
    public void Values_one_by_one_are_read_as_those_of_a_line()
    {
        using var folder = new TemporaryFolder();
        var path = Rewrite(
            folder,
            Split().Description,
            "K0001/1 32.012\nK0002/1 0\nK0004/1 26.11.2026/10:00:00\nK0001/2 5,998\nK0001/3 8.01\nK0001/4 0.001\n"
                + "K0001/5 -1.5\nK0001/6 20.25\nK0001/7 -3\n");
        Assert.Equal(
            [new(32.012, 5.998, 0.001), new Point3(-1.5, 20.25, -3)],
            MeasurementReader.Read(path, MeasurementFormat.Points).Points.Select(p => p.Position));
    }

    [Theory]
    [InlineData(false, "values", MeasurementError.MissingDescription)]
    [InlineData(true, "", MeasurementError.NoPoints)]
    [InlineData(true, "values\nvalues", MeasurementError.SeveralMeasurements)]
    [InlineData(true, "K0001/1 1\nK0001/1 2", MeasurementError.SeveralMeasurements)]
    [InlineData(true, "K0001/1 1\nvalues", MeasurementError.SeveralMeasurements)]
    [InlineData(true, "values\nK0001/1 1", MeasurementError.SeveralMeasurements)]
    [InlineData(true, "K0001/8 1", MeasurementError.BadStructure)]
    public void Values_that_do_not_belong_to_one_piece_are_refused(bool described, string text, string code)
    {
        using var folder = new TemporaryFolder();
        var (description, values) = Split();
        var path = Rewrite(folder, described ? description : null, text.Replace("values", values.Trim(), StringComparison.Ordinal));
        var error = Assert.Throws<InputException>(() => MeasurementReader.Read(path, MeasurementFormat.Points));
        Assert.Equal((code, path), (error.Code, error.File));
    }

    [Fact]
    public void A_description_alone_is_refused_with_what_to_do()
    {
        var error = Assert.Throws<InputException>(() => Text.Read(Split().Description, null, "part.dfd"));
        Assert.Equal(MeasurementError.NoPoints, error.Code);
        Assert.Contains("name the file .dfx", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_description_that_is_a_link_is_not_followed()
    {
        using var folder = new TemporaryFolder();
        var (description, values) = Split();
        var path = Rewrite(folder, null, values);
        File.CreateSymbolicLink(Path.ChangeExtension(path, ".dfd"), folder.Write("elsewhere", description));
        Assert.Equal(
            MeasurementError.MissingDescription,
            Assert.Throws<InputException>(() => MeasurementReader.Read(path, MeasurementFormat.Points)).Code);
    }

    private static (string Description, string Values) Split()
    {
        var at = OwnFormats.Aqdef.IndexOf("32.012", StringComparison.Ordinal);
        return (OwnFormats.Aqdef[..at], OwnFormats.Aqdef[at..]);
    }

    private static string Rewrite(TemporaryFolder folder, string? description, string values)
    {
        if (description is not null)
        {
            folder.Write("part.dfd", description);
        }

        return folder.Write("part.dfx", values);
    }

    // True if it was read.
    private static bool Survives(byte[] bytes, string name)
    {
        try
        {
            var file = MeasurementReader.Read(bytes, name, MeasurementFormat.Recognized);
            Assert.All(file.Points, p => Assert.True(p.Position.IsFinite && p.Label.Length > 0 && p.Line > 0));
            return true;
        }
        catch (InputException e)
        {
            Assert.True(e.Place.Line >= 1 && e.Place.Column >= 1 && e.File == name && e.Code.Length > 0, e.Message);
            Assert.DoesNotContain(e.Message, char.IsControl);
            return false;
        }
    }

    private sealed class TemporaryFolder : IDisposable
    {
        private readonly string _path = Directory.CreateTempSubdirectory("measurement").FullName;

        public string Write(string name, string text)
        {
            var path = Path.Combine(_path, name);
            File.WriteAllBytes(path, OwnFormats.Bytes(text));
            return path;
        }

        public void Dispose() => Directory.Delete(_path, recursive: true);
    }
}
