namespace ErrorMatching.Json.Tests;

public sealed class PathTextTests
{
    [Theory]
    [InlineData(@"jobs\a\job.json", true, "jobs/a/job.json")]
    [InlineData(@"\\mill\programs\O1.NC", true, "//mill/programs/O1.NC")]
    [InlineData(@"C:\jobs/job.json", true, "C:/jobs/job.json")]
    [InlineData(@"odd\name.json", false, @"odd\name.json")]
    public void A_path_is_stated_with_slashes(string path, bool isWindows, string stated) =>
        Assert.Equal(stated, PathText.Of(path, isWindows));

    [Theory]
    [InlineData("jobs/job.json", "a.csv", "jobs/a.csv")]
    [InlineData("job.json", "sub/a.csv", "sub/a.csv")]
    [InlineData("jobs/job.json", "/a.csv", "/a.csv")]
    public void A_name_beside_a_file_is_in_its_folder(string file, string name, string stated) =>
        Assert.Equal(stated, PathText.Beside(file, name));

    [Theory]
    [InlineData(null, "a.csv")]
    [InlineData("", "a.csv")]
    [InlineData("out", "out/a.csv")]
    public void A_name_in_a_folder_is_joined_to_it(string? folder, string stated) => Assert.Equal(stated, PathText.In(folder, "a.csv"));
}
