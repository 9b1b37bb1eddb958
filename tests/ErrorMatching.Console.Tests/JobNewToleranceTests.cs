using System.Globalization;
using System.Text;
using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>What <c>errormatch job new</c> prints of the tolerances of a model.</summary>
public sealed class JobNewToleranceTests
{
    private const string Pocket =
        "G21 G17 G40 G90\nN10 G0 X4. Y4.\nN20 G1 Z-5. F200.\nN40 X56. F500.\nN50 Y36.\nN60 X4.\nN70 Y4.\nN100 G0 Z50.\nM30\n";

    [Fact]
    public void Each_one_is_printed_with_what_it_led_to_and_what_is_left_to_ask()
    {
        using var folder = new TemporaryFolder();
        var (exit, output, error) = Shell.Run(Line(folder));
        Assert.Equal((0, ""), (exit, error));
        string[] lines = [.. output.Split('\n').SkipWhile(l => !l.StartsWith("The model has", StringComparison.Ordinal)).Take(4)];
        Assert.Equal(
            [
                "The model has 3 dimensions and tolerances: 1 became limits, 2 are asked: decide what of them the job needs.",
                "  Profile.1, #200 SURFACE_PROFILE_TOLERANCE 0.2 mm: limits, at least as strict, of L1 [-0.1, 0.1] mm: half of its zone to "
                    + "each side of the outline; it has no datums, so the model lets its zone move, and the limits do not.",
                "  Flat, #201 FLATNESS_TOLERANCE 0.2 mm: asked: it is of the form alone, wherever the feature is, and limits are of its "
                    + "place.",
                "  Broken, #202 SURFACE_PROFILE_TOLERANCE: asked: not understood: #202 SURFACE_PROFILE_TOLERANCE: attribute 3 refers to "
                    + "#777, which the file does not have (line 70).",
            ],
            lines);
        Assert.Contains("The model says no limits of L2, L3, L4: ±0.05 mm stands there", output, StringComparison.Ordinal);
        Assert.Contains(
            "\"toleranceFrom\": \"Profile.1 (#200 SURFACE_PROFILE_TOLERANCE)\"",
            File.ReadAllText(folder["job.json"]),
            StringComparison.Ordinal);
    }

    [Fact]
    public void The_document_lists_them_with_their_values()
    {
        using var folder = new TemporaryFolder();
        var document = Shell.Json(0, "errormatch/job-new-from-outline/1", Line(folder));
        var features = document.GetProperty("features").EnumerateArray().ToArray();
        Assert.Equal("[-0.1,0.1]", Raw(features[0], "toleranceMm"));
        Assert.Equal("Profile.1 (#200 SURFACE_PROFILE_TOLERANCE)", features[0].Text("toleranceFrom"));
        Assert.Equal("null", Raw(features[1], "toleranceMm"));
        var tolerances = document.GetProperty("tolerances").EnumerateArray().ToArray();
        Assert.Equal(["stricter-limits", "asked", "asked"], tolerances.Select(t => t.Text("became")));
        Assert.Equal(
            ("Profile.1", "#200 SURFACE_PROFILE_TOLERANCE", "surface-profile", 0.2, "[\"#10\"]", "[\"L1\"]", "null", "[]", 1.0),
            (
                tolerances[0].Text("name"), tolerances[0].Text("entity"), tolerances[0].Text("kind"),
                tolerances[0].GetProperty("valueMm").GetDouble(), Raw(tolerances[0], "faces"),
                Raw(tolerances[0], "features"), Raw(tolerances[0], "lower"),
                Raw(tolerances[0], "datums"), tolerances[0].GetProperty("unitMm").GetDouble()));
        Assert.Equal(70, tolerances[2].GetProperty("line").GetInt32());
    }

    private static string Raw(JsonElement element, string key) =>
        element.GetProperty(key).GetRawText().Replace(" ", "", StringComparison.Ordinal).Replace("\n", "", StringComparison.Ordinal);

    private static string[] Line(TemporaryFolder folder) => [
        "job", "new", "mating", folder["job.json"], "--outline", folder.File("part.stp", Model()), "--program",
        folder.File("pocket.nc", Pocket), "--tool-diameter", "8"];

    // The top of a plate of 60 by 40 mm, #1, and its side faces #10, #20, #30, #40, of which only the upper edges are written.
    private static string Model()
    {
        (double X, double Y)[] corners = [(0, 0), (60, 0), (60, 40), (0, 40)];
        var text = new StringBuilder("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n");
        text.Append("#1=ADVANCED_FACE('',(#2),#3,.T.);\n#2=FACE_BOUND('',#4,.T.);\n#3=PLANE('',#5);\n#4=EDGE_LOOP('',(#15,#25,#35,#45));\n")
            .Append("#5=AXIS2_PLACEMENT_3D('',#6,$,$);\n#6=CARTESIAN_POINT('',(0.,0.,0.));\n#7=SHAPE_REPRESENTATION('',(#8),#100);\n")
            .Append("#8=SHELL_BASED_SURFACE_MODEL('',(#9));\n#9=OPEN_SHELL('',(#1,#10,#20,#30,#40));\n");
        for (var i = 0; i < 4; i++)
        {
            var ((x, y), (nextX, nextY), n, next) = (corners[i], corners[(i + 1) % 4], 10 * (i + 1), (10 * ((i + 1) % 4)) + 10);
            var (alongX, alongY) = (Math.Sign(nextX - x), Math.Sign(nextY - y));
            text.Append(string.Create(
                CultureInfo.InvariantCulture,
                $"""
                #{n}=ADVANCED_FACE('',(#{n + 1}),#{n + 2},.T.);
                #{n + 1}=FACE_BOUND('',#{n + 3},.T.);
                #{n + 2}=PLANE('',#{n + 4});
                #{n + 3}=EDGE_LOOP('',(#{n + 5}));
                #{n + 4}=AXIS2_PLACEMENT_3D('',#{n + 8},#{n + 110},$);
                #{n + 5}=ORIENTED_EDGE('',*,*,#{n + 6},.T.);
                #{n + 6}=EDGE_CURVE('',#{n + 7},#{next + 7},#{n + 9},.T.);
                #{n + 7}=VERTEX_POINT('',#{n + 8});
                #{n + 8}=CARTESIAN_POINT('',({x:0.0},{y:0.0},0.));
                #{n + 9}=LINE('',#{n + 8},#{n + 111});
                #{n + 110}=DIRECTION('',({alongY}.,{-alongX}.,0.));
                #{n + 111}=VECTOR('',#{n + 112},1.);
                #{n + 112}=DIRECTION('',({alongX}.,{alongY}.,0.));

                """).ReplaceLineEndings("\n"));
        }

        return text.Append(
            """
            #100=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#101))REPRESENTATION_CONTEXT('',''));
            #101=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
            #200=SURFACE_PROFILE_TOLERANCE('Profile.1','',#203,#204);
            #201=FLATNESS_TOLERANCE('Flat','',#203,#204);
            #202=SURFACE_PROFILE_TOLERANCE('Broken','',#777,#204);
            #203=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.2),#101);
            #204=SHAPE_ASPECT('','',$,.T.);
            #205=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#204,#7,#10);
            ENDSEC;
            END-ISO-10303-21;

            """.ReplaceLineEndings("\n")).ToString();
    }
}
