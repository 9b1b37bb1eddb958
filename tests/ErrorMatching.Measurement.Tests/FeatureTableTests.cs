using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement.Tests;

public class FeatureTableTests
{
    private const string Header = "feature,item,nominal,actual,deviation,tolerance\n";

    // Deviations of Wang 2021's complex part as a gauge would print them, with a diameter row between that is no coordinate.
    private const string Two = Header
        + "P1,X,48.050,47.932,-0.118,+/-0.05\n"
        + "P1,Y,48.745,48.7451,0.0001,+/-0.05\n"
        + "P1,D,-,-,-,\n"
        + "P2,X,1,1.0005,0.001,\n"
        + "P2,z,5,5.25,0.25,\n"
        + "P2,Y,2,2,0,\n";

    [Fact]
    public void A_feature_becomes_one_point_of_its_actual_values()
    {
        var file = Text.Read(Two, MeasurementFormat.FeatureTable);
        Assert.Equal(
            [new("P1", new Point3(47.932, 48.7451, 0), false, 2), new LabelledPoint("P2", new Point3(1.0005, 2, 5.25), true, 5)],
            file.Points);
        Assert.Equal(
            [new("P1", new Point3(48.050, 48.745, 0), false, 2), new LabelledPoint("P2", new Point3(1, 2, 5), true, 5)], file.Nominals);
    }

    [Theory]
    [InlineData("A,X,1,1.1,-0.1,", MeasurementError.InconsistentDeviation, 5)]
    [InlineData("A,X,1,1.1,0.2,", MeasurementError.InconsistentDeviation, 5)]
    [InlineData("A,X,1.000,1.100,0.102,", MeasurementError.InconsistentDeviation, 5)]
    [InlineData("A,X,1,=B2,0,", MeasurementError.Formula, 4)]
    [InlineData("A,X,,1,0,", MeasurementError.EmptyCell, 3)]
    [InlineData("A,X,1,1,,", MeasurementError.EmptyCell, 5)]
    [InlineData("A,,1,1,0,", MeasurementError.EmptyCell, 2)]
    [InlineData(",X,1,1,0,", MeasurementError.EmptyCell, 1)]
    [InlineData("P1,x,1,1,0,", MeasurementError.DuplicatePoint, 2)]
    [InlineData("A,X,1,1e7,9999999,", MeasurementError.ImplausibleNumber, 4)]
    public void A_wrong_row_is_named(string row, string code, int column)
    {
        var error = Text.Refused(Two + row + "\n", MeasurementFormat.FeatureTable);
        Assert.Equal((code, 8, column), (error.Code, error.Place.Line, error.Place.Column));
    }

    [Theory]
    [InlineData("1.000,1.100,0.101")]
    [InlineData("1.0,1.14,0.1")]
    [InlineData("1,1.4,0")]
    [InlineData("-32.067,-32.0670,0")]
    public void Three_rounded_numbers_may_differ_by_half_a_digit_each(string numbers) =>
        Assert.Single(Text.Read(Header + $"A,X,{numbers},\nA,Y,0,0,0,\n", MeasurementFormat.FeatureTable).Points);

    [Fact]
    public void A_dropped_zero_does_not_excuse_a_wrong_sign() =>
        Assert.Equal(
            (MeasurementError.InconsistentDeviation, 3),
            Text.Refused(Header + "A,X,48.05,48.17,0.12,\nA,Y,1,1.2,-0.2,\n", MeasurementFormat.FeatureTable) is var e
                ? (e.Code, e.Place.Line)
                : default);

    [Fact]
    public void The_opposite_sign_of_deviations_is_recognized() =>
        Assert.Contains(
            "opposite sign",
            Text.Refused(Header + "A,X,48.050,47.932,0.118,\n", MeasurementFormat.FeatureTable).Message,
            StringComparison.Ordinal);

    [Fact]
    public void A_feature_needs_x_and_y()
    {
        var error = Text.Refused(Two + "A,X,1,1,0,\nA,Z,1,1,0,\n", MeasurementFormat.FeatureTable);
        Assert.Equal((MeasurementError.MissingCoordinate, 8), (error.Code, error.Place.Line));
        Assert.Contains(" Y", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Features_that_are_no_points_are_passed_over() =>
        Assert.Equal(MeasurementError.NoPoints, Text.Refused(Header + "Bore,D,8,8.01,0.01,0.02\n", MeasurementFormat.FeatureTable).Code);

    [Fact]
    public void Inches_convert_nominal_and_actual_alike()
    {
        var file = Text.Read(
            "f,i,n,a\nA,X,1,1.1\nA,Y,2,0.3\n",
            Text.Format(
                """{ "kind": "feature-table", "unit": "inch", "columns": { "feature": "f", "item": "i", "nominal": "n", "actual": "a", "deviation": null } }"""));
        Assert.Equal((new Point3(27.94, 7.62, 0), new Point3(25.4, 50.8, 0)), (file.Points[0].Position, file.Nominals[0].Position));
    }

    [Fact]
    public void Too_many_features_are_refused() =>
        Assert.Equal(
            (MeasurementError.TooManyPoints, 5),
            Text.Refused(Two, MeasurementFormat.FeatureTable with { MaxPoints = 1 }) is var e ? (e.Code, e.Place.Line) : default);
}
