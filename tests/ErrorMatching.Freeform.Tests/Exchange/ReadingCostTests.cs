using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Surface files that repeat one thing for ever.</summary>
public class ReadingCostTests
{
    private const string Step = "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n";

    private static readonly string IgesStart = "A surface".PadRight(72) + "S      1\n";

    [Fact]
    public void Step_files() => Check(
        "a.stp",
        (Step, "#§=CARTESIAN_POINT('',(1.,2.,3.));\n", "ENDSEC;\nEND-ISO-10303-21;\n"),
        (Step, "#1=CARTESIAN_POINT('',(1.,2.,3.));\n", ""),
        (Step, "#§=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#1)),.U.,.F.,.F.,.F.,(2),(2),(0.),(1.),.U.);\n", ""),
        (Step, "#§=ADVANCED_FACE('',(#1),#2,.T.);\n", ""),
        (Step, "#§=(A()B()C());\n", ""),
        (Step, "/**/", ""),
        (Step + "/*", "*", ""),
        (Step, "(", ""),
        (Step, "#", ""),
        (Step, "'", ""),
        (Step, "''", ""),
        (Step + "#1=A(", "1,", ");\n"),
        (Step + "#1=A(", "(", ");\n"),
        (Step + "#1=A('", "x", "');\n"),
        (Step + "#1=A('", "\\X2\\0041\\X0\\", "');\n"),
        (Step + "#1=", "A", "();\n"),
        (Step, "\n", ""),
        (Step, ";", ""),
        ("ISO-10303-21;\n", "HEADER;\nENDSEC;\n", ""));

    [Fact]
    public void Iges_files() => Check(
        "a.igs",
        (IgesStart, IgesStart, ""),
        (IgesStart, "1H,,1H;,".PadRight(72) + "G      1\n", ""),
        (IgesStart, ",".PadRight(72, ',') + "G      1\n", ""),
        (IgesStart, "9999999H".PadRight(72) + "G      1\n", ""),
        (IgesStart, "     128       1       0       0       0       0       0       000000000D      1\n", ""),
        (IgesStart, "128,1,1,1,1,0,0,0,0,0,0.,0.,1.,1.;".PadRight(64) + "       1P      1\n", ""),
        (IgesStart, "\n", ""),
        (IgesStart, "x", ""),
        ("", "S      1\n", ""));

    [Fact]
    public void Grids() => Check("a.csv", ("i,j,x,y,z\n", "§,0,§,0,1\n", ""), ("i,j,x,y,z\n", "0,0,1,2,3\n", ""), ("", ",", ""));

    private static void Check(string name, params (string, string, string)[] inputs) => ReadingCost.IsLinear(
        bytes =>
        {
            try
            {
                Assert.NotNull(SurfaceReader.Read(bytes, name, null, outsideIsUp: true));
            }
            catch (InputException e)
            {
                Assert.InRange(e.Message.Length, 1, 2_000);
            }
        },
        inputs);
}
