using ErrorMatching.Jobs;

namespace ErrorMatching.Console.Tests;

public sealed class OutputFailureTests
{
    [Theory]
    [InlineData(OutputException.Unwritable, 3)]
    [InlineData(OutputException.IsInput, 1)]
    [InlineData(OutputException.Exists, 1)]
    [InlineData(OutputException.Twice, 1)]
    public void Only_a_disk_that_does_not_take_a_file_is_a_failure_outside(string code, int exit)
    {
        var failure = FailureOf.Output(new OutputException(code, "out.nc", "why"));
        Assert.Equal((exit, code, "out.nc"), ((int)failure.Exit, failure.Errors[0].Code, failure.Errors[0].Place.File));
    }
}
