using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Measurement.Tests;

/// <summary>Each reader of gauges' files, with inputs that repeat one thing for ever.</summary>
public class ReadingCostTests
{
    private const string QifHead = """
        <?xml version="1.0"?><QIFDocument xmlns="http://qifstandards.org/xsd/qif3"><FileUnits><PrimaryUnits><LinearUnit><UnitConversion><Factor>0.001</Factor></UnitConversion></LinearUnit></PrimaryUnits></FileUnits>
        """;

    private const string Measured = QifHead + "<MeasurementsResults><MeasurementResultsSet><MeasurementResults><MeasuredFeatures>";

    [Fact]
    public void Qif() => Check(
        "m.qif",
        MeasurementFormat.Points,
        (QifHead + "<A ", "a§=\"\" ", "/>"),
        (QifHead + "<A ", "x:a§='' ", "/>"),
        (QifHead + "<A ", "xmlns:a§='u' ", "/>"),
        (QifHead + "<A a=\"", "&amp;", "\"/>"),
        (QifHead + "<A a=\"", "x", "\"/>"),
        (QifHead, "<A>", ""),
        (QifHead, "<A/>", ""),
        (QifHead, "<a§/>", ""),
        (QifHead, "<!-- - -->", ""),
        (QifHead + "<!--", "- ", "-->"),
        (QifHead + "<A>", "<![CDATA[x]]>", "</A>"),
        (QifHead + "<A>", "]]", "</A>"),
        (QifHead + "<A>", "&#65;", "</A>"),
        (QifHead + "<A>", "x<!-- -->", "</A>"),
        (QifHead + "<A>", "<?p ?>", "</A>"),
        (QifHead + "<", "A", "/>"),
        (Measured, "<PointFeatureMeasurement id=\"§\"><FeatureName>P§</FeatureName><Location>1 2 3</Location></PointFeatureMeasurement>",
            ""),
        (Measured, "<PointFeatureMeasurement id=\"§\"><FeatureName>P§</FeatureName></PointFeatureMeasurement>", ""),
        (Measured + "<PointFeatureMeasurement id=\"1\"><FeatureName>P</FeatureName><Location>", "1 ",
            "</Location></PointFeatureMeasurement>"));

    [Fact]
    public void Aqdef() => Check(
        "m.dfq",
        MeasurementFormat.Points,
        ("K0100 1\n", "K1001 4711\n", ""),
        ("K0100 100000\n", "K2002/§ P§.X\n", ""),
        ("K0100 100000\n", "K2002/1 P1.X\nK0001/1 1\n", ""),
        ("K0100 1\n", "\u000f", ""),
        ("K0100 1\n", "\u0014", ""),
        ("K0100 1\nK2002/1 P1.X\n1", "\u0014", ""),
        ("K0100 1\n", "\n", ""),
        ("K0100 1\n", "\u001a", ""),
        ("K0100 1\n", " ", ""),
        ("K0100 1\nK2002/1 ", "P", "\n"),
        ("K0100 ", "9", "\n"));

    [Fact]
    public void Dmis() => Check(
        "m.dmo",
        MeasurementFormat.Points,
        ("DMISMN/'A',04.0\nUNITS/MM,ANGDEC\n", "FA(P§)=FEAT/POINT,CART,1,2,3,0,0,1\n", ""),
        ("DMISMN/'A',04.0\nUNITS/MM,ANGDEC\n", "FA(P1)=FEAT/POINT,CART,1,2,3,0,0,1\n", ""),
        ("DMISMN/'A',04.0\n", "UNITS/MM,ANGDEC\n", ""),
        ("DMISMN/'A',04.0\n", "$\n", ""),
        ("DMISMN/'A',04.0\n", "A$\n", ""),
        ("DMISMN/'A',04.0\n", "$$", ""),
        ("DMISMN/'A',04.0\n", "(", ""),
        ("DMISMN/'A',04.0\n", ",", ""),
        ("DMISMN/'A',04.0\n", "'", "\n"),
        ("DMISMN/'A',04.0\n", "\r", ""),
        ("DMISMN/'A',04.0\n", "PN(A)=PN/'x'\n", ""),
        ("DMISMN/'A',04.0\nFA(P1)=FEAT/POINT,CART", ",1", "\n"));

    [Fact]
    public void Tables_of_calypso_and_pc_dmis() => Check(
        "m.txt",
        MeasurementFormat.Points,
        ("planid\tpartnb\tid\ttype\tidsymbol\tactual\tnominal\n", "a\tb\tP§.X\txValue\t\t1\t1\n", "END\n"),
        ("planid\tpartnb\tid\ttype\tidsymbol\tactual\tnominal\n", "a\tb\tP1\txValue\t\t1\t1\n", "END\n"),
        ("planid\tpartnb\tid\ttype\tidsymbol\tactual\tnominal\n", "\t", "\n"),
        ("planid\tid\tactual\t", "a\t", "\n"),
        ("planid\tid\tactual", "\n", "\n"),
        (
            "DIM LOC1= LOCATION OF POINT P1  UNITS=MM\nAX    NOMINAL       +TOL       -TOL       MEAS        DEV     OUTTOL\n",
            "X       32.000      0.050      0.050     32.012      0.012      0.000 ----#----\n",
            ""),
        (
            "",
            "DIM LOC1= LOCATION OF POINT P§  UNITS=MM\nAX    NOMINAL       +TOL       -TOL       MEAS        DEV     OUTTOL\n"
                + "X       32.000      0.050      0.050     32.012      0.012      0.000 ----#----\n",
            ""),
        ("", "AX    NOMINAL       +TOL       -TOL       MEAS        DEV     OUTTOL\n", ""),
        ("AX NOMINAL MEAS\n", "x ", "\n"));

    [Fact]
    public void Logs_of_controls() => Check(
        "m.txt",
        MeasurementFormat.Points,
        ("", "1.000000 2.000000 3.000000 0.000000 0.000000 0.000000 0.000000 0.000000 0.000000\n", ""),
        ("", "[PRB:1.000,2.000,3.000:1]\nok\n", ""),
        ("[PRB:1.000,2.000,3.000:1]\n", "[TLO:0.000]\n[PRB:1.000,2.000,3.000:1]\n", ""),
        ("[PRB:", "1,", ":1]\n"),
        ("%\n", "P§ X  1.0 Y 2.0\n", "%\n"),
        ("%\n", "§, 1.0, 2.0\n", "%\n"),
        ("%\n", "%\n", ""),
        ("%\n", "\u0012", "\n"),
        ("%\nP1 X", " ", "1.0 Y2.0\n%\n"),
        ("%\nP1 X1.0 Y", "2", "\n%\n"),
        ("START\n", "G800 N§ X0 Y0 Z0 I0 J1 K0\nG801 N§ X0 Y3 Z0 R3.\n", "END\n"),
        ("START\nG801 N1 ", "X", "\nEND\n"),
        ("", "COMPONENT NO 1 FEATURE NO §\nPOSN X1.0 ACTUAL 1.0 TOL 0.1 DEV 0.0\nPOSN Y1.0 ACTUAL 1.0 TOL 0.1 DEV 0.0\n", ""),
        ("COMPONENT NO 1 FEATURE NO 1\n", "SIZE \n", ""),
        ("COMPONENT NO 1 FEATURE NO 1\nPOSN X", " ", "1.0\n"),
        ("", "CYCLE978 § X Soll 1.0 Ist 1.0 Diff 0.0\nCYCLE978 § Y Soll 1.0 Ist 1.0 Diff 0.0\n", ""),
        ("CYCLE978 1 X Soll ", "1", " Ist 1 Diff 0\n"));

    [Fact]
    public void Logs_by_a_pattern() => Check(
        "m.txt",
        MeasurementFormat.FromJson("""{ "line": "TP{label} {} X{x} Y{y}" }"""),
        ("", "TP§ a X1.0 Y 2.0\n", ""),
        ("TP1 ", "a ", "X1 Y2\n"),
        ("TP", "1", " a X1 Y2\n"),
        ("TP1 a X", "1", " Y2\n"),
        ("TP1 a X", " ", "1 Y2\n"));

    [Theory]
    [InlineData("points", "point,x_mm,y_mm\n")]
    [InlineData("feature-table", "feature,item,nominal,actual,deviation,tolerance\n")]
    [InlineData("grid", "i,j,x,y,z\n")]
    public void Tables(string kind, string header) => Check(
        "m.csv",
        MeasurementFormat.FromJson($"\"{kind}\""),
        (header, "P§,1,2\n", ""),
        (header, "P§,X,1,1,0,0\n", ""),
        (header, "§,0,1,2,3\n", ""),
        (header, "P1,1,2\n", ""),
        (header, ",", "\n"),
        (header, "\"", "\n"),
        (header, "\"\"", "\n"),
        (header + "\"", "\n", "\",1,2\n"),
        (header + "\"", "\r", "\",1,2\n"),
        (header, "\"\n\",", "\n"),
        (header, "\n", ""),
        (header, "\r", ""),
        (header, " ", ""),
        (header, "=", ",1,2\n"),
        (header + "P,", "1", ",2\n"),
        (header + "P,1e", "1", ",2\n"),
        (header, "P§,1e-300,1e300\n", ""),
        ("", "a,", "\nP,1\n"),
        ("", ";", ""),
        ("", "\t", ""),
        ("", "x", ""),
        ("", "N1 ", "\n"),
        ("", "%", "\n"),
        ("", "<", "\n"),
        ("{", "\"", "\n"),
        ("solid", " facet", "\n"));

    private static void Check(string name, MeasurementFormat format, params (string, string, string)[] inputs) => ReadingCost.IsLinear(
        bytes =>
        {
            try
            {
                Assert.NotEmpty(MeasurementReader.Read(bytes, name, format).Points);
            }
            catch (InputException e)
            {
                // A long file has a long line at most in its quote, never whole in a message.
                Assert.InRange(e.Message.Length, 1, 2_000);
            }
        },
        inputs);
}
