using System.Text;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

public sealed class ProbingTemplateTests
{
    [Theory]
    [InlineData("@body\nG0 X{approach.x}\n", 2, "within @each point only")]
    [InlineData("@body\n@each point\nG0 X{aproach.x}\n@next\n", 3, "{aproach.x}")]
    [InlineData("@body\n@each point\nG0 X{approach.x\n@next\n", 3, "closing brace")]
    [InlineData("@body\n@each point\nG0\n", 2, "@next")]
    [InlineData("@body\n@each line\n", 2, "@each point")]
    [InlineData("@body\n@next\n", 2, "@each point before it")]
    [InlineData("@body\n@if along-z\nG0\n@endif\n", 2, "only within @each point")]
    [InlineData("@body\n@if sloping\n", 2, "along-axis")]
    [InlineData("@body\n@each point\n@if along-z\n@else\n@else\n", 5, "@endif")]
    [InlineData("G0\n@body\n", 1, "before it")]
    [InlineData("@body\n@begin\n", 2, "@begin")]
    [InlineData("@body\n@body\n", 2, "second section")]
    [InlineData("@body\n@each point\n@tail\n", 3, "closed before")]
    [InlineData("@head\nG0\n", 2, "no section @body")]
    [InlineData("@body\n@refuse too steep\n", 2, "within @each point")]
    [InlineData("@body\n@each point\n@refuse\n@next\n", 3, "a reason")]
    [InlineData("@assumes\n@body\n", 1, "takes for granted")]
    [InlineData("@body\n@beside\n", 2, "name of a file")]
    [InlineData("@body\n@beside ../MASK.A\n", 2, "name of a file")]
    public void An_error_is_named_by_its_line(string text, int line, string reason)
    {
        var error = Assert.Throws<InputException>(() => ProbingTemplate.Parse(Encoding.UTF8.GetBytes(text), "own.txt"));
        Assert.Equal(("bad-template", "own.txt", line), (error.Code, error.File, error.Place.Line));
        Assert.Contains(reason, error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Doubled_braces_are_braces()
    {
        var template = ProbingTemplate.Parse("@about mine\n@body\n; {{{count}}\nM30\n"u8, "own.txt");
        var program = ProbingProgram.Of(Programs.Plan(), "", NcDialects.Siemens840D, template);
        Assert.Equal("; {20}\nM30\n", Encoding.UTF8.GetString(program.Bytes.Span));
        Assert.Equal("mine", template.About);
    }

    [Fact]
    public void A_dialect_without_a_template_is_refused_with_those_that_there_are()
    {
        var error = Assert.Throws<InputException>(() => ProbingTemplate.Named("delta-nc300"));
        Assert.Equal("unknown-template", error.Code);
        Assert.Contains("fanuc-p98xx", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_shop_s_own_dialect_has_the_template_of_its_family()
    {
        foreach (var name in (string[])["siemens-840d", "fanuc", "linuxcnc", "heidenhain-klartext"])
        {
            var own = NcDialects.Parse(
                Encoding.UTF8.GetBytes($$"""{ "name": "ours", "description": "Ours.", "like": "{{name}}" }"""), "ours.json");
            Assert.Equal(name, ProbingTemplate.For(own).File);
        }

        Assert.Throws<InputException>(() => ProbingTemplate.For(NcDialects.DeltaNc300));
    }

    [Fact]
    public void Every_built_in_template_says_what_it_is_for() =>
        Assert.All(ProbingTemplate.Names, n => Assert.NotEmpty(ProbingTemplate.Named(n).About));
}
