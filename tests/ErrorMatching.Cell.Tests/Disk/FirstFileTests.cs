using System.Globalization;

namespace ErrorMatching.Cell.Tests;

public sealed class FirstFileTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-first-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Of_many_that_put_a_file_at_once_one_succeeds_and_its_file_stays()
    {
        const int Writers = 4;
        for (var round = 0; round < 300; round++)
        {
            var file = PathOf(string.Create(CultureInfo.InvariantCulture, $"file-{round}"));
            var put = new bool[Writers];
            using var start = new Barrier(Writers);
            var writers = Enumerable.Range(0, Writers).Select(i => new Thread(() =>
            {
                var written = $"{file}.{i}";
                File.WriteAllText(written, i.ToString(CultureInfo.InvariantCulture));
                start.SignalAndWait();
                put[i] = FirstFile.TryPut(written, file);
            })).ToArray();
            Array.ForEach(writers, w => w.Start());
            Array.ForEach(writers, w => w.Join());
            var first = Assert.Single(Enumerable.Range(0, Writers), i => put[i]);
            Assert.Equal(first.ToString(CultureInfo.InvariantCulture), File.ReadAllText(file));
            Assert.False(File.Exists($"{file}.{first}"));
        }
    }

    [Fact]
    public void What_is_not_there_cannot_be_put()
    {
        Assert.Throws<FileNotFoundException>(() => FirstFile.TryPut(PathOf("none"), PathOf("file")));
        Assert.False(File.Exists(PathOf("file")));
    }

    private string PathOf(string name) => Path.Combine(_folder, name);
}
