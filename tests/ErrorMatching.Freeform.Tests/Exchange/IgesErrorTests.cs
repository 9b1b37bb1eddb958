using System.Globalization;
using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

/// <summary>What is wrong in an IGES file is named by line and entity, with what was found and what is expected.</summary>
public sealed class IgesErrorTests
{
    private const string Line = "110d 110,0.,0.,0.,60.,0.,0.";
    private const string Surface = "128d F";

    // Entities from D1 on, each as type[:form][d for dependent][@matrix] parameters; F is a flat surface of 60 x 40.
    // The directory begins in line 4.
    [Theory]
    [InlineData("110 110,0.,0.,0.,1.,0.,0.", "no-surface", 4, "128 or 144 is expected", "The file has entities 110 (1, first at D1)")]
    [InlineData(
        "144 144,9,1,0,9", "bad-pointer", 4, "entity 144 at D1 points to D9 for the surface", "the directory has D1 to D1, odd numbers")]
    [InlineData("128 110,0.,0.,0.,1.,0.,0.", "bad-record", 6, "begin with \"110\"", "its type is expected")]
    [InlineData("128@9 F", "bad-pointer", 4, "points to D9 for its transformation matrix", "D1 to D1")]
    [InlineData("128@3 F + " + Line, "bad-pointer", 4, "has entity 110 at D3 for its transformation matrix", "entity 124 is expected")]
    [InlineData("124 124,1.,0.,0.,0.,1.,0.,0.,0.,1.,0.,0.,0. + 128@1 F", "bad-matrix", 8, "flattens space", "a rotation is expected")]
    [InlineData(
        "128 128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.",
        "short-record",
        6,
        "4 parameters are left",
        "24 are expected for knots, weights and poles")]
    [InlineData("128 128,1,1", "short-record", 6, "entity 128 at D1", "the record ends before M1")]
    [InlineData("128 128,1,0,1,1,0,0,1,0,0", "bad-number", 6, "0 for K2", "1 to 4000000 is expected")]
    [InlineData(
        "128 128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,zero,1.,1.,1.,1.,1.,1.,0.,0.,0.,1.,0.,0.,0.,1.,0.,1.,1.,0.",
        "bad-number",
        6,
        "\"zero\" for the knots along v",
        "a number is expected")]
    [InlineData(
        "128 128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,1.,1.,0.,0.,1.,1.,1.,1.,0.,0.,0.,1.,0.,0.,0.,1.,0.,1.,1.,0.",
        "bad-surface",
        4,
        "entity 128 at D1",
        "knot")]
    [InlineData(
        "128 128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,9999999.,0.,0.,0.,1.,0.,9999999.,1.,0.",
        "implausible",
        null,
        "1E+07 mm away from the origin",
        "within 1000000 mm is expected")]
    [InlineData(
        Line + " + 100d 100,0.,0.,40.,60.,40.,0.,100. + 118 118,1,3,0,0",
        "not-read",
        8,
        "entity 118 at D5 of form 0: its rails are joined by their lengths",
        "Export the")]
    [InlineData(
        Line + " + 110d 110,0.,0.,40.,60.,0.,40. + 118:1 118,1,3,0,0",
        "upright-surface",
        null,
        "surface 1 stands upright everywhere",
        "Turn the piece as it is cut, the tool's axis along z")]
    [InlineData(
        Line + " + 110d 110,0.,0.,5.,60.,0.,9. + 120 120,1,3,1.,1.",
        "bad-surface",
        12,
        "entity 120 at D5",
        "angles of revolution that do not rise by a turn at most")]
    [InlineData(Line + " + 102d 102,2,1,1 + 120 120,1,3,0.,1.", "not-read", 6, "entity 102 at D3 joins several curves", "one is expected")]
    [InlineData("108:1 108,0.,0.,0.,5.,3 + " + Line, "bad-surface", 8, "entity 108 at D1", "a plane whose normal has length 0")]
    [InlineData("108:1 108,0.,0.,1.,0.,3 + " + Line, "open-loop", 4, "leave a gap of 60 mm at (60, 0, 0)", "a closed loop is expected")]
    [InlineData(
        Surface + " + 110d 110,0.,0.,0.,1.,0.,0. + 144 144,1,1,0,3",
        "not-read",
        6,
        "entity 110 at D3 as the boundary of a surface",
        "142 or 141 is expected")]
    [InlineData(
        Line + " + 110d 110,0.,40.,0.,60.,40.,0. + 118:1d 118,1,3,0,0 + 142d 142,0,5,1,0,1 + 144 144,5,1,0,7",
        "not-read",
        10,
        "entity 142 at D7 has no curve in space",
        "Export the surface as a B-spline (128)")]
    [InlineData(
        "128 F + 308 308,0,4HPART,1,1 + 408 408,3,0.,0.,30.,1.",
        "assembly",
        4,
        "entity 128 at D1 is a member of the subfigure at D3, which entity 408 at D5 moves or scales",
        "export the part by itself")]
    [InlineData(
        "128 F + 308 308,0,4HPART,1,1 + 408 408,3,0.,0.,0.,2.",
        "assembly",
        4,
        "which entity 408 at D5 moves or scales",
        "in the coordinates in which it is cut")]
    public void A_file_is_refused_with_entity_and_line(string entities, string code, int? line, string found, string expected) =>
        Refused(File(entities).Bytes(), code, line, found, expected);

    [Fact]
    public void A_file_that_is_cut_off_behind_its_directory_is_not_said_to_have_parameters()
    {
        var lines = Encoding.Latin1.GetString(File("128 F").Bytes()).Split('\n');
        var cut = string.Join('\n', lines.Where(l => l.Length > 72 && l[72] is 'S' or 'G' or 'D'));
        Refused(Encoding.Latin1.GetBytes(cut), "bad-pointer", 4, "has its parameters at P1; the file has no parameters", "is it cut off?");
    }

    // The curve at D3, about the surface at D1.
    [Theory]
    [InlineData("112d 112,1", "not-read", 6, "entity 112 at D3 as a curve", "100, 102, 104 (ellipses), 106, 110 and 126 are read")]
    [InlineData("100d 100,0.,30.,20.,30.,20.,30.,20.", "bad-curve", 14, "entity 100 at D3", "an arc of radius 0")]
    [InlineData(
        "104d 104,1.,0.,0.,0.,1.,0.,0.,0.,0.,0.,0.",
        "not-read",
        14,
        "entity 104 at D3",
        "parabola or hyperbola, which is not read: export curves as B-splines (126)")]
    [InlineData("104:1d 104,1.,0.,1.,0.,0.,9.,0.,0.,0.,0.,0.", "bad-curve", 14, "entity 104 at D3", "a conic without points")]
    [InlineData(
        "106:20d 106,1,2,0.,0.,0.,1.,1.", "not-read", 6, "entity 106 at D3 of form 20 as a curve", "forms 11, 12 and 63 are polylines")]
    [InlineData("106:12d 106,2,900,0.,0.,0.,1.,1.,0.", "short-record", 14, "6 parameters are left", "2700 are expected for the points")]
    [InlineData("126d 126,1,1,0,0,1,0,1.,1.,0.,0.,1.,1.,0.,0.,0.,1.,1.,0.,0.,1.", "bad-curve", 6, "entity 126 at D3", "knot")]
    [InlineData(
        "106:11d 106,1,4,0.,0.,0.,2.,0.,2.,1.,0.,0.",
        "limit-off-surface",
        10,
        "goes to (2, 0) of its parameters",
        "which end at 0..1 and 0..1")]
    [InlineData("106:11d 106,1,2,0.,0.,0.,0.,0.", "bad-loop", 10, "a loop of 1 points", "which encloses nothing")]
    [InlineData("102d 102,0", "bad-number", 14, "0 for the number of curves", "1 to 100000 is expected")]
    [InlineData("102d 102,1,99", "bad-pointer", 6, "entity 102 at D3 points to D99 for a curve", "D1 to D7")]
    public void A_limit_is_refused_with_entity_and_line(string curve, string code, int line, string found, string expected) =>
        Refused(File($"{Surface} + {curve} + 142d 142,0,1,3,0,1 + 144 144,1,1,0,5").Bytes(), code, line, found, expected);

    // A piece of a good file changed: its directory is in lines 4 and 5, its parameters in lines 6 and 7.
    [Theory]
    [InlineData("S      1\n", "C      1\n", "compressed", 1, "the compressed form of IGES", "export the fixed form (80 columns)")]
    [InlineData("S      1\n", "B      1\n", "binary", 1, "the binary form of IGES", "export the fixed form (80 columns)")]
    [InlineData("G      1\n", "Q      1\n", "bad-record", 2, "\"Q\" in column 73", "the letter of a section (S, G, D, P, T) is expected")]
    [InlineData("G      1\n", "G      7\n", "bad-record", 2, "record number \"7\" in columns 74 to 80", "1 is expected")]
    [InlineData("made by hand", "made", "bad-record", 1, "a record of 72 columns", "80, with the letter of their section in column 73")]
    [InlineData("made by hand", "made by a strong hand", "bad-record", 1, "a record of 89 columns", "IGES records have 80")]
    [InlineData("     128       1", "     128       x", "bad-number", 4, "\"x\" in field 2 of the directory", "a whole number is expected")]
    [InlineData("     128       1", "     128      99", "bad-pointer", 4, "its parameters at P99", "the file has P1 to P2")]
    [InlineData("1H,,1H;,", "1H,,1H,,", "bad-delimiter", 2, "\",\" and \",\" as delimiters", "two different characters are expected")]
    [InlineData("1.,2,2HMM", "1.,1,2HMM", "bad-unit", 2, "unit flag \"1\" with unit \"MM\"", "1 with INCH, 2 with MM")]
    [InlineData("1.,2,2HMM", "0.,2,2HMM", "bad-unit", 2, "a model space scale of \"0.\"", "a positive number is expected")]
    [InlineData("15,4HTEST", "15,9HTEST", "bad-unit", 2, "a model space scale of \"MM\"", "a positive number is expected")]
    [InlineData(
        "15,4HTEST", "15,5HTEST", "bad-record", 2, "behind a string of 5 characters", "is expected: is the string as long as it says?")]
    [InlineData("15,4HTEST", "15,999HES", "bad-record", 2, "a string of \"999\" characters", "which is longer than what follows")]
    [InlineData(";        ", "         ", "bad-record", 7, "entity 128 at D1", "the record does not end with \";\"")]
    public void A_record_is_refused_with_its_line(string old, string text, string code, int line, string found, string expected)
    {
        var good = Encoding.Latin1.GetString(File("128 F").Bytes());
        Assert.Contains(old, good, StringComparison.Ordinal);
        var at = good.LastIndexOf(old, StringComparison.Ordinal);
        Refused(Encoding.Latin1.GetBytes(good[..at] + text + good[(at + old.Length)..]), code, line, found, expected);
    }

    [Fact]
    public void A_surface_in_a_group_or_a_subfigure_that_stays_where_it_is_is_read()
    {
        var surface = File("128 F + 308 308,0,4HPART,1,1 + 408 408,3,0.,0.,0.,1. + 402:7 402,1,1").Read();
        Assert.Equal(60, surface.Spline.PointAt(1, 1).X);
    }

    [Fact]
    public void A_directory_of_half_an_entity_is_refused()
    {
        var lines = Encoding.Latin1.GetString(File("128 F").Bytes()).Split('\n').ToList();
        lines.RemoveAt(4);
        Refused(Encoding.Latin1.GetBytes(string.Join('\n', lines)), "bad-record", 4, "an odd number of records", "each entity has two");
        Refused(
            Encoding.Latin1.GetBytes(string.Join('\n', lines[..3])),
            "no-directory",
            null,
            "no directory",
            "an IGES file of 80 columns is expected");
    }

    private static void Refused(byte[] file, string code, int? line, string found, string expected)
    {
        var error = Assert.Throws<InputException>(() => SurfaceReader.Read(file, "hand.igs", entity: null, outsideIsUp: true));
        Assert.Equal((code, "hand.igs", line), (error.Code, error.File, error.Place.Line));
        Assert.Contains(found, error.Problem, StringComparison.Ordinal);
        Assert.Contains(expected, error.Problem, StringComparison.Ordinal);
        Assert.StartsWith(line is null ? "hand.igs: " : $"hand.igs, line {line}", error.Message, StringComparison.Ordinal);
    }

    private static IgesText File(string entities)
    {
        var file = new IgesText();
        foreach (var entity in entities.Split(" + "))
        {
            var (head, parameters) = (
                entity[..entity.IndexOf(' ', StringComparison.Ordinal)], entity[(entity.IndexOf(' ', StringComparison.Ordinal) + 1)..]);
            var kind = head.Split('@')[0].TrimEnd('d').Split(':').Select(n => int.Parse(n, CultureInfo.InvariantCulture)).ToArray();
            var matrix = head.Contains('@', StringComparison.Ordinal) ? int.Parse(head.Split('@')[1], CultureInfo.InvariantCulture) : 0;
            file.Add(
                kind[0],
                parameters == "F" ? IgesText.Flat(60, 40) : parameters,
                kind.Length > 1 ? kind[1] : 0,
                head.Contains('d', StringComparison.Ordinal),
                matrix: matrix);
        }

        return file;
    }
}
