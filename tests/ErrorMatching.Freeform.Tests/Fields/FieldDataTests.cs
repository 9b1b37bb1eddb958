namespace ErrorMatching.Freeform.Tests;

public sealed class FieldDataTests
{
    // Each curve in the other direction, as a probe goes.
    [Fact]
    public void Values_measured_to_and_fro_are_thinned_on_lines_of_a_grid()
    {
        const int curves = 31, each = 26;
        var (i, j) = (new int[curves * each], new int[curves * each]);
        for (var k = 0; k < i.Length; k++)
        {
            (j[k], i[k]) = (k / each, k / each % 2 == 0 ? k % each : each - 1 - (k % each));
        }

        var data = new FieldData(
            i,
            j,
            Array.ConvertAll(i, n => (2.0 * n / (each - 1)) - 1),
            Array.ConvertAll(j, n => (2.0 * n / (curves - 1)) - 1),
            new double[i.Length]);
        Assert.All(data.Curves, curve => Assert.Equal(Enumerable.Range(0, each), curve.Select(k => i[k])));

        var few = data.Thinned(10);
        Assert.Equal((10, 10, 100), (few.Curves.Length, few.Crossings.Length, few.Count));
        Assert.NotNull(few.Grid);
    }
}
