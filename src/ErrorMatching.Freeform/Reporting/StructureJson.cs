using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>What the tests of structure found, in the document of a report. The variance is not in it, and nothing but the verdict if that
/// is undetermined.</summary>
internal static class StructureJson
{
    public static void Write(ReportWriter json, SpatialStructure structure)
    {
        json.Text("verdict", Word(structure.Verdict));
        if (structure.Verdict == SpatialVerdict.Undetermined)
        {
            return;
        }

        json.Exact("moransI", structure.I);
        json.Exact("expected", structure.Expectation);
        json.Exact("z", structure.Z);
        json.Exact("p", structure.P);
        json.List("tests", structure.Tests, test =>
        {
            json.Text("test", StructureWords.Of(test.Kind));
            json.Exact("p", test.P);
            if (test.Kind == StructureKind.Neighbors)
            {
                json.Text("are", test.IsOpposite ? "opposite" : "alike");
            }
            else if (test.Kind == StructureKind.Wave)
            {
                WriteLength(json, "lengthUMm", test.WaveMm.U);
                WriteLength(json, "lengthVMm", test.WaveMm.V);
            }
        });
    }

    public static SpatialStructure Read(ReportReader json)
    {
        var verdict = json.Word<SpatialVerdict>("verdict", Word);
        return verdict == SpatialVerdict.Undetermined
            ? new(double.NaN, double.NaN, double.NaN, double.NaN, double.NaN, verdict)
            : new(json.Number("moransI"), json.Number("expected"), double.NaN, json.Number("z"), json.Number("p"), verdict)
            {
                Tests = json.OptionalList("tests", ReadTest),
            };
    }

    private static StructureTest ReadTest(ReportReader json)
    {
        var test = new StructureTest(json.Word<StructureKind>("test", StructureWords.Of), json.Number("p"));
        return test.Kind switch
        {
            StructureKind.Neighbors => test with { IsOpposite = json.Word("are", [true, false], o => o ? "opposite" : "alike") },
            StructureKind.Wave => test with
            {
                WaveMm = (
                    json.OptionalNumber("lengthUMm") ?? double.PositiveInfinity,
                    json.OptionalNumber("lengthVMm") ?? double.PositiveInfinity),
            },
            _ => test,
        };
    }

    // A wave that is constant in a direction has no length there, and JSON has no infinity.
    private static void WriteLength(ReportWriter json, string name, double mm)
    {
        if (double.IsFinite(mm))
        {
            json.Number(name, mm);
        }
    }

    private static string Word(SpatialVerdict verdict) =>
        verdict switch { SpatialVerdict.Systematic => "systematic", SpatialVerdict.Noise => "noise", _ => "undetermined" };
}
