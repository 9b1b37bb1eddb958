namespace ErrorMatching.Mating.Tests;

public sealed class EquationSixTests
{
    // Point 14 of table 6 is printed as -34.033, a copy of point 6; the equation gives -32.174.
    [Theory]
    [InlineData("table6_complex_counterpart_uncompensated.csv", "14")]
    [InlineData("table7_complex_counterpart_compensated.csv", "")]
    public void The_converted_columns_of_tables_6_and_7_come_out_but_for_the_misprint(string table, string misprint)
    {
        var part = Samples.Table("table5_complex_part.csv").ToDictionary(r => r["point"]);

        foreach (var row in Samples.Table(table))
        {
            var actual = part[row["point"]];
            var corrected = EquationSix.Corrected(
                new(actual.Number("x_mm"), actual.Number("y_mm")), new(row.Number("measured_x_mm"), row.Number("measured_y_mm")));

            if (row["point"] == misprint)
            {
                Assert.Equal(-32.174, corrected.X, 9);
                Assert.NotEqual(row.Number("converted_x_mm"), corrected.X, 3);
            }
            else
            {
                Assert.Equal(row.Number("converted_x_mm"), corrected.X, 9);
            }
        }
    }

    [Fact]
    public void The_radius_is_taken_off_both_coordinates_as_printed()
    {
        var corrected = EquationSix.Corrected(new(10, 20), new(10.1, 19.8), 6);

        Assert.Equal(6.9, corrected.X, 12);
        Assert.Equal(17.2, corrected.Y, 12);
    }
}
