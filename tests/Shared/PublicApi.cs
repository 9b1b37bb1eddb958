using System.Reflection;
using System.Text;

namespace ErrorMatching.Testing;

/// <summary>The public surface of a library as text, one member per line, in ordinal order. A test compares it with the PublicApi.txt next
/// to the library's project; with UPDATE_PUBLIC_API=1 in the environment, the test writes that file instead.</summary>
internal static class PublicApi
{
    private static readonly NullabilityInfoContext Nullability = new();

    public static void MatchesSnapshot(Assembly assembly)
    {
        var path = Repository.PathTo("src", assembly.GetName().Name!, "PublicApi.txt");
        var actual = Describe(assembly);
        if (Environment.GetEnvironmentVariable("UPDATE_PUBLIC_API") == "1")
        {
            File.WriteAllText(path, actual);
        }

        Assert.Equal(File.ReadAllText(path), actual);
    }

    private static string Describe(Assembly assembly)
    {
        var text = new StringBuilder();
        foreach (var type in assembly.GetExportedTypes().OrderBy(t => t.FullName, StringComparer.Ordinal))
        {
            text.Append(Kind(type)).Append(' ').Append(Name(type)).Append(Bases(type)).Append('\n');
            var lines = type.GetMembers(
                BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly)
                .Where(IsVisible)
                .Select(Line)
                .OrderBy(l => l, StringComparer.Ordinal);
            foreach (var line in lines)
            {
                text.Append("    ").Append(line).Append('\n');
            }
        }

        return text.ToString();
    }

    private static bool IsVisible(MemberInfo member) => !member.Name.StartsWith('<') && member switch
    {
        ConstructorInfo c => c.IsPublic || c.IsFamily,
        MethodInfo m => (m.IsPublic || m.IsFamily) && (!m.IsSpecialName || m.Name.StartsWith("op_", StringComparison.Ordinal)),
        FieldInfo f => f.IsPublic && !f.IsSpecialName,
        PropertyInfo p => (p.GetMethod ?? p.SetMethod) is { } accessor && (accessor.IsPublic || accessor.IsFamily),
        EventInfo => true,
        _ => false,
    };

    private static string Line(MemberInfo member) => member switch
    {
        ConstructorInfo c => $"new({Parameters(c)})",
        MethodInfo m => $"{(m.IsStatic ? "static " : "")}{Nullable(m.ReturnParameter)} {m.Name}({Parameters(m)})",
        FieldInfo f when f.IsLiteral =>
            $"{f.Name} = {Convert.ToString(f.GetRawConstantValue(), System.Globalization.CultureInfo.InvariantCulture)}",
        FieldInfo f => $"{(f.IsStatic ? "static " : "")}{Name(f.FieldType)} {f.Name}",
        PropertyInfo p => (((p.GetMethod ?? p.SetMethod)!.IsStatic ? "static " : "") + Name(p.PropertyType))
            + (Nullability.Create(p).ReadState == NullabilityState.Nullable && !p.PropertyType.IsValueType ? "?" : "")
            + $" {p.Name} {{ {(p.GetMethod is not null ? "get; " : "")}{(p.SetMethod is { IsPublic: true } ? "set; " : "")}}}",
        _ => member.ToString()!,
    };

    private static string Parameters(MethodBase method) =>
        string.Join(", ", method.GetParameters().Select(p => $"{Nullable(p)} {p.Name}{(p.HasDefaultValue ? " = …" : "")}"));

    private static string Nullable(ParameterInfo parameter) =>
        Name(parameter.ParameterType)
            + (!parameter.ParameterType.IsValueType && Nullability.Create(parameter).ReadState == NullabilityState.Nullable ? "?" : "");

    private static string Kind(Type type) =>
        type.IsEnum
            ? "enum"
            : type.IsInterface
            ? "interface"
            : type.IsValueType
            ? "struct"
            : type is { IsAbstract: true, IsSealed: true }
            ? "static class"
            : type.IsAbstract
            ? "abstract class"
            : "class";

    private static string Bases(Type type) =>
        type.BaseType is { } b && b != typeof(object) && b != typeof(ValueType) && b != typeof(Enum) ? " : " + Name(b) : "";

    private static string Name(Type type)
    {
        if (type.IsByRef)
        {
            return "ref " + Name(type.GetElementType()!);
        }

        if (type.IsArray)
        {
            return Name(type.GetElementType()!) + "[]";
        }

        if (System.Nullable.GetUnderlyingType(type) is { } inner)
        {
            return Name(inner) + "?";
        }

        var name = type.IsNested && !type.IsGenericParameter ? Name(type.DeclaringType!) + "." + type.Name : type.Name;
        return type.IsGenericType ? name.Split('`')[0] + "<" + string.Join(", ", type.GetGenericArguments().Select(Name)) + ">" : name;
    }
}
