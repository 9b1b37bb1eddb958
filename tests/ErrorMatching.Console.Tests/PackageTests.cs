using System.Diagnostics;
using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>What deploy/pack puts into packages. That they install, work and go is tried by deploy/try-packages,
/// which takes minutes.</summary>
public sealed class PackageTests
{
    private static readonly XElement Properties = XDocument.Load(Repository.PathTo("Directory.Build.props")).Root!;
    private static readonly string[] Systems = ["linux-x64", "win-x64"];

    public static TheoryData<string> Scripts =>
    [
        "licenses", "pack", "try-packages",
        .. Directory.EnumerateFiles(Repository.PathTo("deploy", "debian"))
            .Where(f => Path.GetExtension(f) is ".postinst" or ".prerm" or ".postrm")
            .Select(f => "debian/" + Path.GetFileName(f))
            .Order(StringComparer.Ordinal),
    ];

    [Fact]
    public void The_version_is_in_one_place()
    {
        var version = Assert.Single(Properties.Descendants("Version")).Value;
        Assert.Equal(version + "\n", Shell.Run("--version").Output);
        Assert.All(
            Directory.EnumerateFiles(Repository.PathTo("src"), "*.csproj", SearchOption.AllDirectories),
            f => Assert.DoesNotContain("<Version>", File.ReadAllText(f), StringComparison.Ordinal));
    }

    // Its commands, its exits and its places.
    [Fact]
    public void The_manual_page_knows_what_the_help_knows()
    {
        var page = File.ReadAllText(Repository.PathTo("deploy", "errormatch.1")).Replace("\\-", "-", StringComparison.Ordinal);
        var help = Shell.Run("--help").Output;
        var commands = Regex.Matches(help, "^  (?<name>[a-z]+) .*?  (?<says>[A-Z].*\\.)$", RegexOptions.Multiline, TimeSpan.FromSeconds(1));
        Assert.True(commands.Count > 8);
        Assert.All(
            commands,
            c => Assert.Contains($".TP\n.B {c.Groups["name"].Value}\n{c.Groups["says"].Value}\n", page, StringComparison.Ordinal));
        Assert.All(
            Regex.Matches(page, "/opt/errormatch/(?<file>[a-z0-9./-]+)", RegexOptions.IgnoreCase, TimeSpan.FromSeconds(1)),
            m => Assert.True(File.Exists(Repository.PathTo(m.Groups["file"].Value)), m.Value));
        var exits = File.ReadAllText(Repository.PathTo("docs", "reference-console.md"));
        Assert.All(
            Regex.Matches(exits, "^\\| (?<exit>[0-9]+) \\|", RegexOptions.Multiline, TimeSpan.FromSeconds(1)),
            m => Assert.Contains($".TP\n.B {m.Groups["exit"].Value}\n", page, StringComparison.Ordinal));
    }

    // Restoring for a system that is not in its lock file would change the file.
    [Fact]
    public void Every_lock_file_knows_the_systems_that_are_published_for()
    {
        Assert.Equal(string.Join(';', Systems), Assert.Single(Properties.Descendants("RuntimeIdentifiers")).Value);
        var files = Directory.EnumerateFiles(Repository.PathTo("src"), "packages.lock.json", SearchOption.AllDirectories).ToArray();
        Assert.True(files.Length > 10);
        Assert.All(files, f => Assert.All(
            Systems, s => Assert.Contains($"\"net10.0/{s}\"", File.ReadAllText(f), StringComparison.Ordinal)));
    }

    [Fact]
    public void The_configuration_of_the_package_is_right_and_names_the_places_of_the_unit()
    {
        var file = Repository.PathTo("deploy", "cell.json");
        var text = File.ReadAllText(file);
        var here = text.Replace("/opt/errormatch", Repository.Root.Replace('\\', '/'), StringComparison.Ordinal);
        Assert.Empty(CellSettingsReader.Parse(Encoding.UTF8.GetBytes(here), file).Warnings);
        Assert.Contains("\"approve\": \"person\"", text, StringComparison.Ordinal);
        var unit = File.ReadAllText(Repository.PathTo("deploy", "errormatch-cell.service"));
        var script = File.ReadAllText(Repository.PathTo("deploy", "debian", "errormatch.postinst"));
        Assert.Contains("ReadWritePaths=-/srv/errormatch\n", unit, StringComparison.Ordinal);
        Assert.Contains("ExecStart=/opt/errormatch/errormatch cell run /etc/errormatch/cell.json\n", unit, StringComparison.Ordinal);
        Assert.All(
            Regex.Matches(text, "\"(?<folder>/(var|srv)/[a-z/]+)\"", RegexOptions.ExplicitCapture, TimeSpan.FromSeconds(1))
                .Select(m => m.Groups["folder"].Value),
            folder => Assert.True(
                folder == "/var/lib/errormatch/keys" || script.Contains(" " + folder, StringComparison.Ordinal),
                $"Nobody makes {folder}."));
    }

    [Fact]
    public void The_unit_s_account_is_the_one_that_the_package_makes()
    {
        var unit = File.ReadAllText(Repository.PathTo("deploy", "errormatch-cell.service"));
        Assert.Contains("\nUser=errormatch\nGroup=errormatch\n", unit, StringComparison.Ordinal);
        Assert.Contains(
            "useradd --system --user-group --home-dir /var/lib/errormatch --no-create-home --shell /usr/sbin/nologin errormatch\n",
            File.ReadAllText(Repository.PathTo("deploy", "debian", "errormatch.postinst")),
            StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("errormatch")]
    [InlineData("errormatch-station")]
    public void A_control_file_has_what_dpkg_demands(string package)
    {
        var lines = File.ReadAllLines(Repository.PathTo("deploy", "debian", package + ".control"));
        var fields = lines.Where(l => !l.StartsWith(' '))
            .Select(l => l.Split(": ", 2))
            .ToDictionary(f => f[0], f => f[1], StringComparer.Ordinal);
        Assert.Equal(
            (package, "@VERSION@", "amd64", "@SIZE@"),
            (fields["Package"], fields["Version"], fields["Architecture"], fields["Installed-Size"]));
        Assert.All(new[] { "Maintainer", "Description", "Depends" }, f => Assert.NotEqual("", fields[f]));
        Assert.All(lines, l => Assert.NotEqual("", l.Trim()));
    }

    [Theory]
    [MemberData(nameof(Scripts))]
    public void A_script_is_one_that_its_shell_understands(string script)
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "These scripts run on Linux.");
        var file = Repository.PathTo("deploy", script);
        var shell = File.ReadLines(file).First() is "#!/bin/sh" ? "sh" : "bash";
        using var process = Process.Start(
            new ProcessStartInfo(shell, ["-n", file]) { UseShellExecute = false, RedirectStandardError = true })!;
        var said = process.StandardError.ReadToEnd();
        process.WaitForExit();
        Assert.Equal((0, ""), (process.ExitCode, said));
        Assert.Contains("\nset -e", File.ReadAllText(file), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("errormatch-station.desktop", "errormatch-station /etc/errormatch/cell.json")]
    [InlineData("errormatch-station-demo.desktop", "errormatch-station --demo")]
    public void The_menu_starts_the_station(string file, string command)
    {
        var lines = File.ReadAllLines(Repository.PathTo("deploy", "debian", file));
        Assert.Equal("[Desktop Entry]", lines[0]);
        Assert.Contains("Exec=" + command, lines);
        Assert.Contains("Icon=errormatch", lines);
        Assert.Contains(lines, l => l.StartsWith("Name[zh_TW]=", StringComparison.Ordinal));
    }

    [Fact]
    public void The_icon_is_drawn_from_its_only_source()
    {
        Python.IsNeeded();
        using var folder = new TemporaryFolder();
        string[] files = ["deploy/icon.png", "src/ErrorMatching.Hmi.Desktop/station.ico"];
        Assert.Equal(0, Python.Run(folder.Path, "tools/icon.py", files.Select(Path.GetFileName).OfType<string>()).Exit);
        Assert.All(
            files, f => Assert.Equal(File.ReadAllBytes(Repository.PathTo(f)), File.ReadAllBytes(folder[Path.GetFileName(f)])));
        Assert.Contains(
            "\"_appLogoPath\": \"deploy/icon.svg\"", File.ReadAllText(Repository.PathTo("docfx.json")), StringComparison.Ordinal);
    }

    [Fact]
    public void A_package_without_a_license_text_gets_that_of_the_license_that_it_names()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Packages are made on Linux.");
        using var folder = new TemporaryFolder();
        Package(folder, "own", "<license type=\"file\">LICENSE.md</license>", "LICENSE.md");
        Package(folder, "named", "<license type=\"expression\">MS-PL OR MIT</license><copyright>Jones &amp; Sons</copyright>", "NOTICE");

        Assert.Equal((0, ""), Licenses(folder, "Own", "Named"));
        Assert.Equal(["LICENSE.md"], Texts(folder, "Own"));
        Assert.Equal(["LICENSE.txt", "NOTICE"], Texts(folder, "Named"));
        var text = File.ReadAllText(Path.Combine(folder["out"], "Named", "LICENSE.txt"));
        Assert.StartsWith("Named 1.0.0\nJones & Sons\n\nMIT License\n", text, StringComparison.Ordinal);
        Assert.Contains("\nPermission is hereby granted, free of charge, ", text, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("<license type=\"expression\">Nobody-1.0</license>", "deploy/license-texts has none of its license: Nobody-1.0.")]
    [InlineData("<license type=\"expression\">MIT AND Nobody-1.0</license>", "has none of its license: MIT AND Nobody-1.0.")]
    [InlineData("<licenseUrl>https://localhost/license</licenseUrl>", "has none of its license: it names none.")]
    public void A_package_without_any_license_text_is_refused_by_name(string license, string said)
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Packages are made on Linux.");
        using var folder = new TemporaryFolder();
        Package(folder, "own", "", "LICENSE");
        Package(folder, "bare", license, "README.md");
        var (exit, error) = Licenses(folder, "Own", "Bare");
        Assert.Equal(1, exit);
        Assert.StartsWith("Bare 1.0.0 brings no license text, and ", error, StringComparison.Ordinal);
        Assert.EndsWith(said + "\n", error, StringComparison.Ordinal);
    }

    [Fact]
    public void A_part_of_the_bill_that_is_no_package_here_is_refused_by_name()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Packages are made on Linux.");
        using var folder = new TemporaryFolder();
        Directory.CreateDirectory(folder["packages"]);
        var (exit, error) = Licenses(folder, "Gone");
        Assert.Equal(1, exit);
        Assert.Contains("Gone 1.0.0 is in the bill of materials, but not in ", error, StringComparison.Ordinal);
    }

    private static void Package(TemporaryFolder folder, string name, string license, string file)
    {
        var package = Directory.CreateDirectory(Path.Combine(folder["packages"], name, "1.0.0")).FullName;
        File.WriteAllText(Path.Combine(package, name + ".nuspec"), license.Replace("><", ">\n<", StringComparison.Ordinal) + "\n");
        File.WriteAllText(Path.Combine(package, file), "text");
    }

    private static (int Exit, string Error) Licenses(TemporaryFolder folder, params IEnumerable<string> packages)
    {
        var bill = folder.File("bill.json", string.Concat(packages.Select(p => $"  \"purl\": \"pkg:nuget/{p}@1.0.0\",\n")));
        using var process = Process.Start(
            new ProcessStartInfo(Repository.PathTo("deploy", "licenses"), [bill, folder["packages"], folder["out"]])
            {
                UseShellExecute = false,
                RedirectStandardError = true,
            })!;
        var error = process.StandardError.ReadToEnd();
        process.WaitForExit();
        return (process.ExitCode, error);
    }

    private static IEnumerable<string?> Texts(TemporaryFolder folder, string package) =>
        Directory.EnumerateFiles(Path.Combine(folder["out"], package)).Select(Path.GetFileName).Order(StringComparer.Ordinal);
}
