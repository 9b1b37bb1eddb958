using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement.Tests;

/// <summary>The log of our own probing programs, as a mating job reads it.</summary>
public sealed class ProbingLogTests
{
    private const string Head = "ERRORMATCH PROBE PLAN 0123456789ABCDEF MM\n";

    [Fact]
    public void Points_come_in_the_order_of_the_plan_and_each_says_what_it_is()
    {
        var file = Read(
            "%\n; by the control\n" + Head + "P2 S X  1.5000 Y -2.2500 Z0.\nP1 C X-  .5 Y1.2E-07 Z-5.0\nP3 C X0 Y3EX-02 Z-5\nEND\n%\n");
        Assert.True(file.IsByOrder);
        Assert.Equal("0123456789ABCDEF", file.Plan);
        Assert.Equal(
            [("1", -0.5, 1.2e-7, -5), ("2", 1.5, -2.25, 0), ("3", 0, 0.03, -5)],
            file.Points.Select(p => (p.Label, p.Position.X, p.Position.Y, p.Position.Z)));
        var named = file.InOrderOf(["a", "b", "c"]);
        Assert.Equal([true, false, true], new[] { "a", "b", "c" }.Select(l => named.IsCenter(l)!.Value));
        Assert.Equal(1.5, named["b"].Position.X);
    }

    [Fact]
    public void Other_files_do_not_say_what_a_point_is()
    {
        var file = Read("point,x_mm,y_mm\n1,2,3\n");
        Assert.Null(file.Plan);
        Assert.Null(file.IsCenter("1"));
    }

    [Theory]
    [InlineData(Head + "P1 C X1 Y2 Z3\nP1 C X1 Y2 Z3\n", MeasurementError.DuplicatePoint, 3)]
    [InlineData(Head + "P1 C X1 Y2 Z3\nP3 C X1 Y2 Z3\n", MeasurementError.MissingPoint, 3)]
    [InlineData(Head + "P2 C X1 Y2 Z3\n", MeasurementError.MissingPoint, 2)]
    [InlineData(Head + "P1 C X1 Y2\n", MeasurementError.BadStructure, 2)]
    [InlineData(Head + "P1 Q X1 Y2 Z3\n", MeasurementError.BadStructure, 2)]
    [InlineData(Head + "P1.5 C X1 Y2 Z3\n", MeasurementError.BadStructure, 2)]
    [InlineData(Head + "P1 C X1 Y2 Z3\nEND\nP2 C X1 Y2 Z3\n", MeasurementError.BadStructure, 4)]
    [InlineData(Head + "P1 C X1 Y2 Z3\n" + Head + "P2 C X1 Y2 Z3\n", MeasurementError.SeveralMeasurements, 3)]
    [InlineData(Head + "P1 C X12345678 Y2 Z3\n", MeasurementError.ImplausibleNumber, 2)]
    [InlineData("ERRORMATCH PROBE PLAN 0123456789ABCDEF INCH\nP1 C X1 Y2 Z3\n", MeasurementError.BadStructure, 1)]
    [InlineData(Head + "END\n", MeasurementError.NoPoints, 1)]
    public void What_is_wrong_is_named_with_its_line(string text, string code, int line)
    {
        var error = Assert.Throws<InputException>(() => Read(text));
        Assert.Equal((code, line), (error.Code, error.Place.Line));
    }

    private static MeasurementFile Read(string text) =>
        MeasurementReader.Read(Encoding.ASCII.GetBytes(text), "probe.log", MeasurementFormat.Recognized);
}
